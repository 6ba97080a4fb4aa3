#include "device/registry.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

namespace ssrkit {
namespace {

TEST(Registry, AnUnknownDeviceIsAnErrorThatListsTheKnownOnes) {
  const auto missing = findDevice("gl-osmeza");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().kind, ErrorKind::kInput);
  const std::string text = sentence(missing.error());
  for (const char* const part : {"gl-osmeza", "gl-osmesa", "vk-lavapipe", "did you mean 'gl-osmesa'"}) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  }
}

TEST(Registry, EveryRowIsFoundByItsId) {
  for (const DeviceEntry& entry : deviceEntries()) {
    const auto found = findDevice(entry.id);
    ASSERT_TRUE(found);
    EXPECT_EQ(*found, &entry);
    EXPECT_FALSE(entry.description.empty());
  }
}

// Both ways round: a machine with a GPU has the device, one without is told why not and what to install.
TEST(Registry, ADeviceOfHardwareIsThereOrSaysWhyNot) {
  int count = 0;
  for (const DeviceEntry& entry : deviceEntries()) {
    if (entry.is_software) {
      continue;
    }
    ++count;
    const auto created = entry.create();
    if (created) {
      EXPECT_EQ((*created)->identity().id, entry.id);
      EXPECT_EQ((*created)->identity().driver.find("llvmpipe"), std::string::npos);
      continue;
    }
    EXPECT_EQ(created.error().kind, ErrorKind::kSetup);
    EXPECT_NE(sentence(created.error()).find("Debian"), std::string::npos) << sentence(created.error());
    EXPECT_NE(sentence(created.error()).find("GPU"), std::string::npos) << sentence(created.error());
  }
  EXPECT_EQ(count, 2);
}

std::string loadedDrivers() {
  std::ifstream file("/proc/self/maps");
  const std::string maps(std::istreambuf_iterator<char>(file), {});
  std::string found = maps.find("libc") == std::string::npos ? "nothing at all?" : "";
  for (const char* const library : {"OSMesa", "libvulkan", "LLVM", "libGL", "libEGL", "swiftshader"}) {
    found += maps.find(library) == std::string::npos ? "" : library;
  }
  return found;
}

// The supervisor lists devices; drivers belong to the workers. In a process of its own, where no test has
// opened one.
TEST(RegistryDeathTest, ListingTheDevicesLoadsNoDriver) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto list = [] {
    const bool is_listed = !deviceEntries().empty();
    const std::string drivers = loadedDrivers();
    std::fputs(drivers.c_str(), stderr);
    std::_Exit(is_listed && drivers.empty() ? 0 : 1);
  };
  EXPECT_EXIT(list(), testing::ExitedWithCode(0), "^$");
}

}  // namespace
}  // namespace ssrkit
