// What the tests of the devices share: each test runs on every software device of the registry, and fails on
// any message that the driver or the validation layer leaves behind.
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/check.h"
#include "base/error.h"
#include "device/device.h"
#include "device/registry.h"

namespace ssrkit {

// A program and the code that its descriptor points to.
struct ProgramSource {
  ShaderModule vertex;
  ShaderModule fragment;
  ProgramDesc desc;  // spans into the modules; formats and attributes are the test's to fill in
};

class DeviceTest : public testing::TestWithParam<std::string> {
 public:
  [[nodiscard]] static std::vector<std::string> allDevices();

 protected:
  void SetUp() override;
  void TearDown() override;

  [[nodiscard]] Device& device() { return *device_; }
  [[nodiscard]] const DeviceEntry& entry() const { return *entry_; }
  [[nodiscard]] ShaderTarget target() const { return entry_->target; }

  // Compiles tests/unit/device/shaders/NAME for this device. A test's shader that does not compile ends the
  // test.
  [[nodiscard]] ProgramSource compile(const std::string& vertex, const std::string& fragment) const;
  [[nodiscard]] std::unique_ptr<DeviceProgram> program(const ProgramDesc& desc);
  // A full-screen program with these colour targets.
  [[nodiscard]] std::unique_ptr<DeviceProgram> screenProgram(const std::string& fragment,
                                                             std::vector<Format> colour_formats);

  [[nodiscard]] std::unique_ptr<DeviceImage> image(Format format, Size size, int mip_count = 1);
  template <class T>
  void upload(DeviceImage& image, int mip, const std::vector<T>& values) {
    const auto done = device().upload(image, mip, std::as_bytes(std::span(values)));
    ASSERT_TRUE(done) << sentence(done.error());
  }
  template <class T>
  [[nodiscard]] std::vector<T> read(const DeviceImage& image, int mip = 0) {
    const std::vector<std::byte> bytes = readBytes(image, mip);
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
  }
  [[nodiscard]] std::vector<std::byte> readBytes(const DeviceImage& image, int mip);

  PassTime draw(const PassDesc& pass);

 private:
  const DeviceEntry* entry_ = nullptr;
  std::unique_ptr<Device> device_;
};

// A pass of one program that draws to one whole mip.
[[nodiscard]] PassDesc passTo(DeviceImage& image, const DeviceProgram& program, int mip = 0);

template <class T>
[[nodiscard]] std::span<const std::byte> bytesOf(const T& value) {
  return std::as_bytes(std::span(&value, 1));
}

// The value, or the end of the test program with the error's sentence.
template <class T>
[[nodiscard]] T valueOf(Expected<T> result) {
  if (!result) {
    ADD_FAILURE() << sentence(result.error());
  }
  SSRKIT_CHECK(result.has_value());
  return std::move(*result);
}

// "gl-osmesa" as part of a test's name, which may hold no hyphen.
[[nodiscard]] std::string nameOfDevice(const testing::TestParamInfo<std::string>& info);

}  // namespace ssrkit

#define SSRKIT_ON_EVERY_DEVICE(suite) \
  INSTANTIATE_TEST_SUITE_P(On, suite, testing::ValuesIn(DeviceTest::allDevices()), nameOfDevice)
