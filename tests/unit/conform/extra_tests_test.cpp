#include "conform/extra_tests.h"

#include <gtest/gtest.h>

namespace ssrkit {
namespace {

TestFile made(const std::string& id, const std::vector<std::string>& devices = {}) {
  TestFile test;
  test.id = id;
  test.devices = devices;
  test.stages = {"hiz"};
  test.input = "gl-a";
  test.cases = {TestCase{.name = "thin"}};
  test.expectations = {Expectation{}};
  return test;
}

std::vector<std::string> idsOf(const std::vector<TestFile>& tests) {
  std::vector<std::string> ids;
  ids.reserve(tests.size());
  for (const TestFile& test : tests) {
    ids.push_back(test.id);
  }
  return ids;
}

TEST(ExtraTests, DrawTheCasesOfATestAndExpectNothing) {
  const std::vector<TestFile> tests = {made("trace.bits")};
  const auto extra = extraTests(tests, {.safety = true, .validate = "gpu,core"}, {"vk-a", "vk-b"});
  EXPECT_EQ(idsOf(extra), (std::vector<std::string>{"safety.trace.bits", "validate.core.trace.bits",
                                                    "validate.gpu.trace.bits"}));
  for (const TestFile& test : extra) {
    EXPECT_EQ(test.stages, tests[0].stages);
    EXPECT_EQ(test.cases.at(0).name, "thin");
    EXPECT_TRUE(test.expectations.empty());
    EXPECT_TRUE(test.input.empty());
  }
  EXPECT_TRUE(extra[0].devices.empty()) << "the run's";
  EXPECT_EQ(extra[1].devices, (std::vector<std::string>{"vk-a", "vk-b"}));
  EXPECT_TRUE(extraTests(tests, {}, {"vk-a"}).empty());
}

TEST(ExtraTests, AskNoVariantAgainAndValidateNoOtherApi) {
  std::vector<TestFile> tests = {made("a", {"gl-a", "vk-b"}), made("b", {"gl-a"}), made("c")};
  tests[2].cases.push_back({.name = "tiled", .variant = "tiled"});
  const auto extra = extraTests(tests, {.safety = true, .validate = "sync"}, {"vk-a", "vk-b"});
  EXPECT_EQ(idsOf(extra), (std::vector<std::string>{"safety.a", "safety.b", "validate.sync.a"}));
  EXPECT_EQ(extra[2].devices, (std::vector<std::string>{"vk-b"}));
}

TEST(ExtraTests, AreKnownByTheirNames) {
  EXPECT_TRUE(passesOf("safety.trace.bits").safety);
  EXPECT_EQ(passesOf("validate.sync.trace.bits").validate, "sync");
  for (const char* const id : {"trace.safety.bits", "validate.trace", "safetyx", "validate.cores.a"}) {
    EXPECT_FALSE(isExtraTest(id)) << id;
  }
}

TEST(ExtraTests, ACommandAsksForWhatItsCellsAreDrawnFor) {
  EXPECT_EQ(conformCommandFor({"t/m1/64x36/gl-a"}), "./ssrkit conform --filter t/m1/64x36/gl-a");
  EXPECT_EQ(conformCommandFor({"safety.t/m1/64x36/gl-a"}),
            "./ssrkit conform --safety --filter safety.t/m1/64x36/gl-a");
  EXPECT_EQ(conformCommandFor({"validate.gpu.t/m1/64x36/vk-a", "validate.core.t/m1/64x36/vk-a"}),
            "./ssrkit conform --validate core,gpu --filter validate.gpu.t/m1/64x36/vk-a "
            "--filter validate.core.t/m1/64x36/vk-a");
}

TEST(ExtraTests, AKindOfCheckThatNobodyKnowsIsNamed) {
  EXPECT_EQ(problemWithChecks("core,sync,gpu"), "");
  EXPECT_NE(problemWithChecks("core,speed").find("'speed'"), std::string::npos);
  EXPECT_NE(problemWithChecks("").find("''"), std::string::npos);
}

}  // namespace
}  // namespace ssrkit
