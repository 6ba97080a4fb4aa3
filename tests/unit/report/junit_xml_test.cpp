#include "report/junit_xml.h"

#include <gtest/gtest.h>

#include <pugixml.hpp>
#include <vector>

namespace ssrkit {
namespace {

CheckResult checkWith(Outcome outcome, const std::string& device = "gl-osmesa") {
  CheckResult check{.id = "t.finite", .scene = "m1", .device = device, .stage = "hiz", .size = {64, 32}};
  check.outcome = outcome;
  check.metric = "finite";
  check.unit = "pixels";
  return check;
}

pugi::xml_document parsed(const RunReport& report) {
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_string(junitXml(report).c_str());
  EXPECT_TRUE(result) << result.description();
  return document;
}

// The element that the check's only test case holds, "" for a pass.
std::string elementOf(Outcome outcome) {
  RunReport report;
  report.checks = {checkWith(outcome)};
  const pugi::xml_document document = parsed(report);
  const pugi::xml_node suite = document.child("testsuites").child("testsuite");
  const pugi::xml_node only = suite.child("testcase").first_child();
  // The suite counts what its test cases hold.
  EXPECT_EQ(suite.attribute("failures").as_int(), std::string(only.name()) == "failure" ? 1 : 0);
  EXPECT_EQ(suite.attribute("errors").as_int(), std::string(only.name()) == "error" ? 1 : 0);
  EXPECT_EQ(suite.attribute("skipped").as_int(), std::string(only.name()) == "skipped" ? 1 : 0);
  EXPECT_STREQ(only.attribute("type").value(), only ? name(outcome) : "");
  return only.name();
}

TEST(JunitXml, EveryOutcomeHasItsElement) {
  const std::pair<Outcome, const char*> wanted[] = {
      {Outcome::kPass, ""},         {Outcome::kWarn, ""},         {Outcome::kFail, "failure"},
      {Outcome::kError, "error"},   {Outcome::kSkip, "skipped"},  {Outcome::kCrash, "error"},
      {Outcome::kTimeout, "error"}, {Outcome::kLimiter, "error"}, {Outcome::kFlake, ""},
      {Outcome::kMissing, "error"}, {Outcome::kXfail, "skipped"}, {Outcome::kXpass, "failure"},
      {Outcome::kInconclusive, ""}};
  static_assert(std::size(wanted) == kOutcomeCount);
  for (const auto& [outcome, element] : wanted) {
    EXPECT_EQ(elementOf(outcome), element) << name(outcome);
  }
}

TEST(JunitXml, AFailureSaysWhatItIsAndHowToRunItAgain) {
  RunReport report;
  CheckResult check = checkWith(Outcome::kFail);
  check.value = 3.0;
  check.max = 0.0;
  check.message = "fail: t.finite\n  again     ./ssrkit run --scene m1";
  report.checks = {check};
  const pugi::xml_document document = parsed(report);
  const pugi::xml_node test = document.select_node("//testcase").node();
  EXPECT_STREQ(test.attribute("classname").value(), "gl-osmesa.t.finite");
  EXPECT_STREQ(test.attribute("name").value(), "m1 64x32 hiz");
  EXPECT_STREQ(test.child("failure").attribute("message").value(), "finite = 3 pixels, expected <= 0 pixels");
  EXPECT_EQ(test.child("failure").child_value(), check.message);
}

TEST(JunitXml, WhatIsExpectedToFailTellsItsReason) {
  RunReport report;
  CheckResult check = checkWith(Outcome::kXfail);
  check.value = 3.0;
  check.message = "expected failure: rounds to even\nfail: t.finite";
  report.checks = {check};
  const pugi::xml_document document = parsed(report);
  EXPECT_STREQ(document.select_node("//skipped").node().attribute("message").value(),
               "expected failure: rounds to even");
}

TEST(JunitXml, AFlakeIsAPassThatItsSuiteNames) {
  RunReport report;
  CheckResult check = checkWith(Outcome::kFlake);
  check.message = "failed once in three";
  report.checks = {check};
  const pugi::xml_document document = parsed(report);
  EXPECT_STREQ(document.select_node("//property[@name='flake']").node().attribute("value").value(),
               "t.finite m1 64x32 gl-osmesa hiz: failed once in three");
}

TEST(JunitXml, EachDeviceIsASuiteThatSaysWhoItIs) {
  RunReport report;
  report.started = "2026-01-31T12:00:00Z";
  report.devices = {{.identity = {.id = "vk-lavapipe", .driver = "llvmpipe", .version = "Mesa 22.3.6"}}};
  report.checks = {checkWith(Outcome::kPass), checkWith(Outcome::kFail, "vk-lavapipe"),
                   checkWith(Outcome::kPass), checkWith(Outcome::kMissing, "")};
  const pugi::xml_document document = parsed(report);
  std::vector<std::string> suites;
  for (const pugi::xml_node suite : document.child("testsuites").children()) {
    suites.emplace_back(suite.attribute("name").value());
    EXPECT_STREQ(suite.attribute("timestamp").value(), "2026-01-31T12:00:00");  // Ant's schema takes no zone
  }
  EXPECT_EQ(suites, (std::vector<std::string>{"gl-osmesa", "vk-lavapipe", "no-device"}));
  EXPECT_EQ(document.select_node("//testsuite[@name='gl-osmesa']").node().attribute("tests").as_int(), 2);
  EXPECT_STREQ(document.select_node("//testsuite[@name='vk-lavapipe']/properties/property[@name='version']")
                   .node()
                   .attribute("value")
                   .value(),
               "Mesa 22.3.6");
}

TEST(JunitXml, ASuitesTimeIsThatOfItsChecks) {
  RunReport report;
  report.checks = {checkWith(Outcome::kPass), checkWith(Outcome::kFail), checkWith(Outcome::kPass, "gl-b")};
  report.checks[0].time_s = 0.25;
  report.checks[1].time_s = 1.5;
  report.checks[2].time_s = 1234.5;
  const pugi::xml_document document = parsed(report);
  EXPECT_STREQ(document.select_node("//testcase").node().attribute("time").value(), "0.250");
  EXPECT_STREQ(document.select_node("//testsuite[1]").node().attribute("time").value(), "1.750");
  EXPECT_STREQ(document.select_node("//testsuite[2]").node().attribute("time").value(), "1234.500");
}

TEST(JunitXml, WhatXmlCannotHoldIsReplacedAndWhatItReservesIsEscaped) {
  RunReport report;
  CheckResult check = checkWith(Outcome::kCrash);
  check.scene = "<scene name=\"&\">";
  check.message = "\x1B[31m]]> \xFF </error>";
  report.checks = {check};
  EXPECT_EQ(junitXml(report).find('\x1B'), std::string::npos);
  EXPECT_EQ(junitXml(report).find("&#27;"),
            std::string::npos);  // no reference to a forbidden character either
  const pugi::xml_document document = parsed(report);
  EXPECT_STREQ(document.select_node("//testcase").node().attribute("name").value(),
               "<scene name=\"&\"> 64x32 hiz");
  EXPECT_STREQ(document.select_node("//error").node().child_value(), "\uFFFD[31m]]> \uFFFD </error>");
}

}  // namespace
}  // namespace ssrkit
