// Expectations that are asked of some devices only: by name, or by how alike they are to the truth's.
#include <gtest/gtest.h>

#include "check/judge.h"
#include "made_answers.h"

namespace ssrkit {
namespace {

KnownNames fourDevices() {
  return {.devices = {"gl-a", "gl-b", "vk-c", "vk-d"},
          .tolerance_class = [](const std::string& a, const std::string& b) -> std::string {
            if (a == b || (a.starts_with("gl") && b.starts_with("gl"))) {
              return "P";
            }
            return a == "vk-d" || b == "vk-d" ? "X" : "R";
          }};
}

Expected<TestFile> readWith(const std::string& keys) {
  return readExpectations(
      "[test]\nid = \"t\"\nabout = \"a\"\nscenes = [\"all\"]\nstages = [\"hiz\"]\n[[expect]]\n" + keys,
      "t.toml", fourDevices());
}

std::vector<std::string> askedDevices(const std::string& keys) {
  Bench bench;
  for (const std::string& device : fourDevices().devices) {
    bench.add("hiz", shiftedRecord({4, 4}), device);
  }
  const auto test = readWith(keys);
  EXPECT_TRUE(test.has_value()) << sentence(test.error());
  std::vector<std::string> devices;
  for (const CheckResult& result : judge(*test, "made", bench.answers, [](const Answer&) { return ""; })) {
    devices.push_back(result.device);
  }
  return devices;
}

using Names = std::vector<std::string>;

TEST(DeviceScope, NamedDevicesAlone) {
  EXPECT_EQ((Names{"gl-b", "vk-d"}), askedDevices("metric = \"finite\"\ndevices = [\"gl-b\", \"vk-d\"]\n"));
}

TEST(DeviceScope, APairIsAllDevicesOfItsClassButTheTruthItself) {
  const std::string keys = "metric = \"identical\"\ntruth = \"cross:gl-a\"\npair = ";
  EXPECT_EQ((Names{"gl-b"}), askedDevices(keys + "\"P\"\n"));
  EXPECT_EQ((Names{"vk-c"}), askedDevices(keys + "\"R\"\n"));
  EXPECT_EQ((Names{"vk-d"}), askedDevices(keys + "\"X\"\n"));
}

TEST(DeviceScope, WhatIsAskedOfOthersIsNotMissing) {
  Bench bench;
  bench.add("hiz", shiftedRecord({4, 4}), "gl-a");
  const auto test = readWith("metric = \"finite\"\ndevices = [\"vk-d\"]\n");
  EXPECT_TRUE(judge(*test, "made", bench.answers, [](const Answer&) { return ""; }).empty());
}

TEST(DeviceScope, WrongNamesAndPairsWithoutASecondDeviceAreErrors) {
  for (const char* keys :
       {"metric = \"finite\"\ndevices = [\"vk-e\"]\n", "metric = \"finite\"\npair = \"P\"\n",
        "metric = \"identical\"\ntruth = \"cross:gl-a\"\npair = \"Q\"\n",
        "metric = \"identical\"\ntruth = \"case:x\"\npair = \"P\"\n",
        "metric = \"identical\"\ntruth = \"cross:gl-a\"\npair = \"P\"\ndevices = [\"gl-b\"]\n"}) {
    const auto test = readWith(keys);
    ASSERT_FALSE(test.has_value()) << keys;
    EXPECT_NE(std::string::npos, test.error().where.find("t.toml:")) << keys;
  }
}

}  // namespace
}  // namespace ssrkit
