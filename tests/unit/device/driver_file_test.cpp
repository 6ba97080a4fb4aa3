#include "device/vulkan/driver_file.h"

#include <gtest/gtest.h>

namespace ssrkit::vulkan {
namespace {

TEST(DriverFile, OfSeveralArchitecturesThisOneIsChosenWhateverTheOrder) {
#if defined(__x86_64__)
  const std::string own = "lvp_icd.x86_64.json";
#elif defined(__aarch64__)
  const std::string own = "lvp_icd.aarch64.json";
#else
  GTEST_SKIP() << "no name of this processor is known";
  const std::string own;
#endif
  EXPECT_EQ(own, driverFileAmong({"lvp_icd.i686.json", own, "lvp_icd.armv7l.json"}));
  EXPECT_EQ(own, driverFileAmong({own, "lvp_icd.i686.json"}));
}

TEST(DriverFile, WithoutANameOfAnArchitectureTheFirstByNameIsChosen) {
  EXPECT_EQ("a_icd.json", driverFileAmong({"b_icd.json", "a_icd.json"}));
  EXPECT_EQ("", driverFileAmong({}));
}

}  // namespace
}  // namespace ssrkit::vulkan
