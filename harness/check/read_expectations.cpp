#include "check/read_expectations.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "base/atomic_file.h"
#include "base/size.h"
#include "base/text.h"
#include "check/field_reader.h"
#include "check/read_case_section.h"
#include "check/read_expect_section.h"

namespace ssrkit {

namespace {

const std::vector<std::string> kTestFileKeys = {"test", "case", "expect"};
const std::vector<std::string> kTestKeys = {"id",      "about",  "scenes", "camera",     "sizes",
                                            "devices", "stages", "tags",   "input",      "rounds",
                                            "frame",   "frames", "time_s", "time_step_s"};

Expected<void> readTestSection(const TomlValue& table, const KnownNames& known, const std::string& attempted,
                               TestFile& test) {
  FieldReader fields(table, "[test]", test.file, attempted);
  fields.allowOnly(kTestKeys);
  test.id = fields.text("id");
  fields.requirePlainId("id", test.id);
  test.about = fields.text("about");
  test.scenes = fields.texts("scenes");
  test.camera = fields.optionalText("camera").value_or("");
  test.devices = fields.optionalTexts("devices");
  test.stages = fields.optionalTexts("stages");
  test.tags = fields.optionalTexts("tags");
  test.input = fields.optionalText("input").value_or("");
  test.frame = fields.optionalText("frame").value_or(test.frame);
  constexpr int kMostRounds = 1000;
  test.rounds = fields.integer("rounds", 1, kMostRounds).value_or(0);
  constexpr int kMostFrames = 1000;
  test.frames = fields.integer("frames", 1, kMostFrames);
  constexpr double kLongestTime = 1e6;
  test.time_s = fields.number("time_s", -kLongestTime, kLongestTime);
  test.time_step_s = fields.number("time_step_s", 0.0, kLongestTime);
  for (const std::string& text : fields.optionalTexts("sizes")) {
    const std::optional<Size> size = parseSize(text);
    if (!size) {
      fields.complain("sizes", fmt::format("'{}' is no size of 1 to {} texels a side", text, kMaxImageSide),
                      "write it as \"640x360\"");
      break;
    }
    test.sizes.push_back(*size);
  }
  const auto require_all_known = [&](std::string_view key, const std::vector<std::string>& words,
                                     std::string_view what, const std::vector<std::string>& names) {
    for (const std::string& word : words) {
      if (!names.empty()) {
        fields.requireKnown(key, word, what, names);
      }
    }
  };
  if (test.scenes != std::vector<std::string>{"all"}) {
    require_all_known("scenes", test.scenes, "scene", known.scenes);
  }
  require_all_known("devices", test.devices, "device", known.devices);
  require_all_known("stages", test.stages, "stage", known.stages);
  require_all_known("frame", {test.frame}, "frame", known.frames);
  if (!test.input.empty() && !known.devices.empty()) {
    fields.requireKnown("input", test.input, "device", known.devices);
  }
  return fields.result();
}

Expected<void> requireSections(const TomlValue& document, std::string_view key, const std::string& file,
                               const std::string& attempted) {
  const TomlEntry* entry = document.find(key);
  if (entry == nullptr) {
    return {};
  }
  const auto is_table = [](const TomlValue& value) { return value.kind == TomlValue::Kind::kTable; };
  if (entry->value.kind == TomlValue::Kind::kArray && std::ranges::all_of(entry->value.elements, is_table)) {
    return {};
  }
  return inputError(attempted, fmt::format("'{}' must be sections, not {}", key, name(entry->value.kind)),
                    placeText(file, entry->key_place), fmt::format("write it as [[{}]]", key));
}

Expected<void> readCases(const TomlValue& document, const KnownNames& known, const std::string& attempted,
                         TestFile& test) {
  if (auto sections = requireSections(document, "case", test.file, attempted); !sections) {
    return sections;
  }
  if (const TomlEntry* cases = document.find("case")) {
    for (const TomlValue& table : cases->value.elements) {
      Expected<TestCase> test_case = readCaseSection(table, test, known, attempted);
      if (!test_case) {
        return tl::make_unexpected(test_case.error());
      }
      test.cases.push_back(std::move(*test_case));
    }
  }
  if (test.cases.empty()) {
    test.cases.emplace_back();
  }
  return {};
}

Expected<void> readExpects(const TomlValue& document, const KnownNames& known, const ReadRules& rules,
                           const std::string& attempted, TestFile& test) {
  if (auto sections = requireSections(document, "expect", test.file, attempted); !sections) {
    return sections;
  }
  const TomlEntry* expects = document.find("expect");
  if (expects == nullptr || expects->value.elements.empty()) {
    return inputError(attempted, "the file expects nothing", placeText(test.file, document.place),
                      "add at least one [[expect]] section");
  }
  for (const TomlValue& table : expects->value.elements) {
    Expected<Expectation> expectation = readExpectSection(table, test, known, rules, attempted);
    if (!expectation) {
      return tl::make_unexpected(expectation.error());
    }
    if (std::ranges::find(test.expectations, expectation->name, &Expectation::name) !=
        test.expectations.end()) {
      return inputError(attempted, fmt::format("two expectations are named '{}'", expectation->name),
                        expectation->where, "give one of them another name = \"...\"");
    }
    test.expectations.push_back(std::move(*expectation));
  }
  return {};
}

}  // namespace

Expected<TestFile> readExpectations(std::string_view content, const std::string& file,
                                    const KnownNames& known) {
  const Expected<TomlValue> document =
      parseToml(content, file, fmt::format("read the expectations '{}'", file));
  return document ? readExpectations(*document, file, known, {}) : tl::make_unexpected(document.error());
}

Expected<TestFile> readExpectations(const TomlValue& document, const std::string& file,
                                    const KnownNames& known, const ReadRules& rules) {
  const std::string attempted = fmt::format("read the expectations '{}'", file);
  TestFile test;
  test.file = file;
  FieldReader top(document, "the file", file, attempted);
  std::vector<std::string> keys = kTestFileKeys;
  keys.insert(keys.end(), rules.top_keys.begin(), rules.top_keys.end());
  top.allowOnly(keys);
  const TomlEntry* section = document.find("test");
  if (section == nullptr || section->value.kind != TomlValue::Kind::kTable) {
    top.complain("test", "the file has no [test] section", "begin it with [test]");
  }
  if (!top.ok()) {
    return tl::make_unexpected(top.result().error());
  }
  const Expected<void> read =
      readTestSection(section->value, known, attempted, test)
          .and_then([&] { return readCases(document, known, attempted, test); })
          .and_then([&] { return readExpects(document, known, rules, attempted, test); });
  if (!read) {
    return tl::make_unexpected(read.error());
  }
  return test;
}

Expected<std::vector<std::filesystem::path>> tomlFiles(const std::filesystem::path& path,
                                                       const std::string& attempted) {
  std::vector<std::filesystem::path> files;
  std::error_code failure;
  if (std::filesystem::is_directory(path, failure)) {
    for (const auto& entry : std::filesystem::directory_iterator(path, failure)) {
      if (entry.path().extension() == ".toml") {
        files.push_back(entry.path());
      }
    }
    std::ranges::sort(files);
  } else {
    files.push_back(path);
  }
  if (failure || files.empty()) {
    return inputError(attempted, failure ? failure.message() : "the folder holds no .toml file",
                      path.string());
  }
  return files;
}

Expected<std::vector<TestFile>> loadExpectations(const std::filesystem::path& path, const KnownNames& known) {
  const std::string attempted = fmt::format("read the expectations in '{}'", path.string());
  const auto files = tomlFiles(path, attempted);
  if (!files) {
    return tl::make_unexpected(files.error());
  }
  std::vector<TestFile> tests;
  for (const std::filesystem::path& file : *files) {
    const Expected<std::string> content = readFile(file);
    if (!content) {
      return tl::make_unexpected(content.error());
    }
    Expected<TestFile> test = readExpectations(*content, file.string(), known);
    if (!test) {
      return tl::make_unexpected(test.error());
    }
    const auto twin = std::ranges::find(tests, test->id, &TestFile::id);
    if (twin != tests.end()) {
      return inputError(attempted, fmt::format("the id '{}' is also used by '{}'", test->id, twin->file),
                        test->file, "give one of them another id");
    }
    tests.push_back(std::move(*test));
  }
  return tests;
}

}  // namespace ssrkit
