// A device for the tests of passes: each test runs on every device of the registry, in its own process.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "device/registry.h"

namespace ssrkit {

class FrameDeviceTest : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    const auto entry = findDevice(GetParam());
    ASSERT_TRUE(entry.has_value());
    for (const auto& [name, value] : (*entry)->environment) {
      ASSERT_EQ(setenv(name.c_str(), value.c_str(), 1), 0);
    }
    auto created = (*entry)->create();
    ASSERT_TRUE(created.has_value()) << sentence(created.error());
    device_ = std::move(*created);
    target_ = (*entry)->target;
  }
  void TearDown() override {
    if (device_ != nullptr) {
      EXPECT_EQ(device_->drainMessages(), std::vector<std::string>{});
    }
  }

  std::unique_ptr<Device> device_;
  ShaderTarget target_ = ShaderTarget::kOpenGl;
};

inline std::string deviceTestName(const testing::TestParamInfo<std::string>& parameter) {
  std::string name = parameter.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

}  // namespace ssrkit
