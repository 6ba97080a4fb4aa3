#include "conform/extra_tests.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "base/text.h"

namespace ssrkit {

namespace {

constexpr std::array<std::string_view, 3> kChecks{"core", "sync", "gpu"};
constexpr std::string_view kSafety = "safety.";
constexpr std::string_view kValidate = "validate.";

bool asksInOneWay(const TestFile& test) {
  return std::ranges::all_of(test.cases, [](const TestCase& test_case) { return test_case.variant.empty(); });
}

TestFile drawnAgain(const TestFile& test, std::string_view prefix) {
  TestFile again = test;
  again.id = std::string(prefix) + test.id;
  again.expectations.clear();
  again.input.clear();
  again.rounds = 0;
  return again;
}

}  // namespace

std::string problemWithChecks(const std::string& text) {
  for (const std::string& word : split(text, ',')) {
    if (std::ranges::find(kChecks, word) == kChecks.end()) {
      return fmt::format("'{}' is none of {}", word, fmt::join(kChecks, ", "));
    }
  }
  return "";
}

std::vector<TestFile> extraTests(std::span<const TestFile> tests, const ExtraPasses& passes,
                                 const std::vector<std::string>& vulkan_devices) {
  std::vector<TestFile> extra;
  const auto add = [&](const std::string& prefix, const std::vector<std::string>* devices) {
    for (const TestFile& test : tests) {
      if (!asksInOneWay(test)) {
        continue;
      }
      TestFile again = drawnAgain(test, prefix);
      if (devices != nullptr) {
        std::vector<std::string> own = test.devices.empty() ? *devices : test.devices;
        std::erase_if(own, [&](const std::string& device) {
          return std::ranges::find(*devices, device) == devices->end();
        });
        again.devices = std::move(own);
      }
      if (devices == nullptr || !again.devices.empty()) {
        extra.push_back(std::move(again));
      }
    }
  };
  if (passes.safety) {
    add(std::string(kSafety), nullptr);
  }
  const std::vector<std::string> asked = split(passes.validate, ',');
  for (const std::string_view check : kChecks) {
    if (std::ranges::find(asked, check) != asked.end()) {
      add(fmt::format("{}{}.", kValidate, check), &vulkan_devices);
    }
  }
  return extra;
}

ExtraPasses passesOf(std::string_view test_id) {
  ExtraPasses passes;
  passes.safety = test_id.starts_with(kSafety);
  for (const std::string_view check : kChecks) {
    if (test_id.starts_with(fmt::format("{}{}.", kValidate, check))) {
      passes.validate = check;
    }
  }
  return passes;
}

bool isExtraTest(std::string_view test_id) {
  const ExtraPasses passes = passesOf(test_id);
  return passes.safety || !passes.validate.empty();
}

std::string conformCommandFor(const std::vector<std::string>& cell_ids) {
  std::string command = "./ssrkit conform";
  const auto add = [&command](const std::string& words) {
    command += command.find(words) == std::string::npos ? words : "";
  };
  std::set<std::string> checks;
  for (const std::string& id : cell_ids) {
    const ExtraPasses passes = passesOf(id);
    add(passes.safety ? " --safety" : "");
    checks.insert(passes.validate);
  }
  checks.erase("");
  add(checks.empty() ? "" : fmt::format(" --validate {}", fmt::join(checks, ",")));
  for (const std::string& id : cell_ids) {
    add(" --filter " + id);
  }
  return command;
}

}  // namespace ssrkit
