#include "command/unit_tests.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <thread>
#include <vector>

#include "base/atomic_file.h"
#include "command/child_program.h"

namespace ssrkit {

namespace {

const std::string kAttemptedTests = "run the unit tests";

// CTest filters by regular expression: everything but * stands for itself.
std::string regexOf(const std::string& filter) {
  std::string regex = "^";
  for (const char letter : filter) {
    if (letter == '*') {
      regex += ".*";
    } else {
      regex += std::strchr(".+?()[]{}|^$\\", letter) != nullptr ? fmt::format("\\{}", letter)
                                                                : std::string(1, letter);
    }
  }
  return regex + "$";
}

Expected<int> runCtest(const std::filesystem::path& build, const std::vector<std::string>& options,
                       const std::filesystem::path& output) {
  std::vector<std::string> arguments = {"ctest", "--test-dir", build.string()};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return runChild({.arguments = arguments,
                   .output = output,
                   .limit = kNoLimit,
                   .remedy = "install the package cmake, which has it"});
}

// A number from the attributes of <testsuite ...>, which stand on lines of their own.
Expected<std::size_t> attribute(const std::string& junit, const std::string& name) {
  const std::size_t start = junit.find("<testsuite");
  const std::size_t end = start == std::string::npos ? start : junit.find('>', start);
  std::string attributes = end == std::string::npos ? "" : junit.substr(start, end - start);
  std::ranges::replace_if(
      attributes, [](char letter) { return letter == '\n' || letter == '\t'; }, ' ');
  const std::string key = " " + name + "=\"";
  const std::size_t at = attributes.find(key);
  std::size_t number = 0;
  if (at == std::string::npos) {
    return setupError(kAttemptedTests, fmt::format("CTest's report has no '{}'", name));
  }
  std::from_chars(attributes.data() + at + key.size(), attributes.data() + attributes.size(), number);
  return number;
}

}  // namespace

Expected<UnitTestCounts> runUnitTests(const std::filesystem::path& build, const std::string& filter,
                                      UnitTestOutput output) {
  const std::filesystem::path junit_file = build / "unit-tests.xml";
  std::error_code ignored;
  std::filesystem::remove(junit_file, ignored);
  const auto code = runCtest(
      build,
      {"--output-on-failure", "--progress", "-j", std::to_string(std::thread::hardware_concurrency()), "-R",
       regexOf(filter), "--output-junit", junit_file.string()},
      output == UnitTestOutput::kToFile ? build / "unit-tests.log" : std::filesystem::path());
  if (!code) {
    return tl::make_unexpected(code.error());
  }
  const auto junit = readFile(junit_file);
  if (!junit) {
    return tl::make_unexpected(junit.error());
  }
  const auto tests = attribute(*junit, "tests");
  const auto failures = tests ? attribute(*junit, "failures") : tests;
  const auto disabled = failures ? attribute(*junit, "disabled") : failures;
  const auto skipped = disabled ? attribute(*junit, "skipped") : disabled;
  if (!skipped) {
    return tl::make_unexpected(skipped.error());
  }
  UnitTestCounts counts{
      .passed = *tests - *failures - *skipped - *disabled, .failed = *failures, .skipped = *skipped};
  // CTest may fail for reasons that no test stands for: a test program that cannot be started, a set-up that
  // failed.
  if (*code != 0 && counts.failed == 0 && *tests > 0) {
    return setupError(kAttemptedTests, fmt::format("ctest ended with {} though no test failed", *code));
  }
  return counts;
}

Expected<void> listUnitTests(const std::filesystem::path& build, const std::string& filter) {
  const auto code = runCtest(build, {"-N", "-R", regexOf(filter)}, {});
  return code ? Expected<void>{} : tl::make_unexpected(code.error());
}

}  // namespace ssrkit
