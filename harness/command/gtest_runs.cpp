#include "command/gtest_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <set>

#include "base/atomic_file.h"
#include "base/text.h"
#include "command/child_program.h"

namespace ssrkit {

namespace {

namespace fs = std::filesystem;

// "Each/TracersTest" and "TracersTest/0" are suites called TracersTest.
std::string plainSuite(const std::string& suite) {
  const std::vector<std::string> parts = split(suite, '/');
  const bool ends_in_number = !parts.back().empty() && std::isdigit(parts.back().front()) != 0;
  return ends_in_number ? parts.front() : parts.back();
}

std::string plainName(const std::string& suite, const std::string& test) {
  return plainSuite(suite) + "." + test.substr(0, test.find('/'));
}

// The lines of --gtest_list_tests: a suite with a dot at its end, then its tests, indented.
void addListed(const std::string& listing, const std::string& room, UnitTestRooms& rooms) {
  std::string suite;
  for (const std::string& line : split(listing, '\n')) {
    const std::string word = line.substr(0, line.find("  #"));
    if (word.starts_with("  ")) {
      rooms[plainName(suite, word.substr(2))] = room;
    } else if (word.ends_with(".")) {
      suite = word.substr(0, word.size() - 1);
    }
  }
}

std::string filterOf(const std::vector<std::string>& tests, const std::string& instance) {
  std::string filter;
  for (const std::string& test : tests) {
    filter += fmt::format("{0}:{0}/*{1}:*/{0}/*{1}:*/{0}:", test, instance);
  }
  return filter;
}

std::string firstLine(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

// GoogleTest's JSON report; a complaint without the line of the source that it begins with.
std::map<std::string, std::string> readReport(const nlohmann::json& report) {
  std::map<std::string, std::string> said;
  for (const nlohmann::json& suite : report.at("testsuites")) {
    for (const nlohmann::json& test : suite.at("testsuite")) {
      std::string& complaint = said[plainName(suite.at("name"), test.at("name"))];
      if (test.contains("failures") && complaint.empty()) {
        const std::string text = test.at("failures").at(0).at("failure");
        const std::size_t line_end = text.find('\n');
        complaint = firstLine(line_end == std::string::npos ? text : text.substr(line_end + 1));
        complaint = complaint.empty() ? "failed" : complaint;
      }
    }
  }
  return said;
}

// None when the program ended before its report was written.
Expected<std::optional<std::map<std::string, std::string>>> runOnce(const UnitTestRun& run,
                                                                    const std::vector<std::string>& tests) {
  const fs::path report = run.scratch / "unit-tests.json";
  std::error_code ignored;
  fs::remove(report, ignored);
  ChildProgram child{.arguments = {run.program.string(), "--gtest_filter=" + filterOf(tests, run.instance),
                                   "--gtest_output=json:" + report.string()},
                     .environment = run.environment,
                     .folder = {},
                     .output = run.scratch / "unit-tests.log"};
  const auto code = runChild(child);
  if (!code) {
    return tl::make_unexpected(code.error());
  }
  const auto content = readFile(report);
  const auto json = content ? nlohmann::json::parse(*content, nullptr, false) : nlohmann::json();
  const bool is_whole = *code <= 1 && json.is_object();
  return is_whole ? std::optional(readReport(json)) : std::nullopt;
}

}  // namespace

Expected<UnitTestRooms> findUnitTests(const fs::path& build, const fs::path& scratch) {
  constexpr std::string_view kPrefix = "test_";
  UnitTestRooms rooms;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(build / "bin", ignored)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(kPrefix) || entry.path().has_extension()) {
      continue;
    }
    const auto code = runChild({.arguments = {entry.path().string(), "--gtest_list_tests"},
                                .environment = {},
                                .folder = {},
                                .output = scratch / name});
    const auto listing = code ? readFile(scratch / name) : tl::make_unexpected(code.error());
    if (!listing) {
      return tl::make_unexpected(listing.error());
    }
    addListed(*listing, name.substr(kPrefix.size()), rooms);
  }
  if (rooms.empty()) {
    return setupError("find the unit tests", "none is built", (build / "bin").string(),
                      "build all targets: ./ssrkit test --list does");
  }
  return rooms;
}

Expected<std::map<std::string, std::string>> runUnitTests(const UnitTestRun& run) {
  const auto together = runOnce(run, run.tests);
  if (!together) {
    return tl::make_unexpected(together.error());
  }
  if (together->has_value()) {
    return **together;
  }
  // One of them ended the program: each by itself.
  std::map<std::string, std::string> said;
  for (const std::string& test : run.tests) {
    const auto alone = runOnce(run, {test});
    if (!alone) {
      return tl::make_unexpected(alone.error());
    }
    if (alone->has_value()) {
      said.insert((*alone)->begin(), (*alone)->end());
    } else {
      said[test] = "the test ended the program, or did not end in time";
    }
  }
  return said;
}

}  // namespace ssrkit
