#include "command/mutant_battery.h"

#include <fmt/format.h>

#include <algorithm>

#include "check/outcome.h"
#include "check/read_expectations.h"
#include "command/known_names.h"
#include "frame/frames.h"
#include "frame/stages.h"
#include "frame/techniques.h"

namespace ssrkit {

namespace {

constexpr const char* kDevice = "gl-osmesa";  // of tests that name none

void addPasses(const std::vector<FramePass>& passes, std::set<std::string>& entries) {
  for (const FramePass& pass : passes) {
    entries.insert(passRow(pass).fragment_shader);
  }
}

// Names were checked when the file was read.
std::set<std::string> entriesOf(const TestFile& file) {
  std::set<std::string> entries = {"gbuffer.vert", "gbuffer.frag", "full_screen.vert"};
  const auto frame = findFrameKind(file.frame);
  addPasses((*frame)->passes, entries);
  if (entries.contains("shadow.frag")) {
    entries.insert({"shadow_map.vert", "shadow_map.frag", "shadow_map_masked.frag"});
  }
  for (const TestCase& test_case : file.cases) {
    for (const std::string& name : file.stages) {
      const auto stage = findStage(name);
      const std::string shader = shaderOf(**stage, askedParameters({}, **stage, test_case.parameters));
      entries.insert(shader);
      if (shader.starts_with("trace_hiz")) {
        entries.insert({"pyramid_base.frag", "pyramid_reduce.frag"});
      }
    }
    if (const auto technique = findTechnique(test_case.technique); technique) {
      addPasses((*technique)->before_pyramid, entries);
      addPasses((*technique)->before_trace, entries);
      addPasses((*technique)->after_sample, entries);
      addPasses((*technique)->after_trace, entries);
    }
  }
  return entries;
}

// Where and how much, in one line.
std::string complaintOf(const CheckResult& check) {
  const std::string place = fmt::format("{} {}x{}{}{}", check.scene, check.size.width, check.size.height,
                                        check.stage.empty() ? "" : " " + check.stage,
                                        check.case_name.empty() ? "" : " " + check.case_name);
  return check.value ? fmt::format("{:.4g} {} on {}", *check.value, check.unit, place)
                     : fmt::format("{} on {}", name(check.outcome), place);
}

}  // namespace

Expected<std::vector<BatteryTest>> loadBattery(const KitPaths& paths) {
  const auto files = loadExpectations(paths.battery, knownNames(paths));
  if (!files) {
    return tl::make_unexpected(files.error());
  }
  std::vector<BatteryTest> battery;
  for (const TestFile& file : *files) {
    BatteryTest test{.file = file, .sources = {}, .entries = entriesOf(file)};
    if (test.file.devices.empty()) {
      test.file.devices = {kDevice};
    }
    for (const std::string& scene : file.scenes) {
      auto source = Suite::source(scene, paths.scenes);
      if (!source) {
        return tl::make_unexpected(source.error());
      }
      test.sources.push_back(std::move(*source));
    }
    battery.push_back(std::move(test));
  }
  return battery;
}

std::vector<std::string> checksOf(const TestFile& file) {
  std::vector<std::string> checks;
  for (const Expectation& expectation : file.expectations) {
    checks.push_back(file.id + "." + expectation.name);
  }
  return checks;
}

Expected<std::unique_ptr<Suite>> batterySuite(const std::vector<BatteryTest>& battery,
                                              const KitPaths& paths) {
  SuiteOptions options;
  options.shader_root = paths.shaders;
  options.scenes_root = paths.scenes;
  options.size = {64, 36};
  // A mutant may march for ever; the battery's own jobs take a second.
  options.limits = {.wall = std::chrono::seconds(20), .cpu = std::chrono::seconds(40)};
  std::set<std::string> devices;
  for (const BatteryTest& test : battery) {
    devices.insert(test.file.devices.begin(), test.file.devices.end());
  }
  options.devices = {devices.begin(), devices.end()};
  return Suite::create(std::move(options));
}

std::map<std::string, std::string> runBatteryTest(Suite& suite, const BatteryTest& test,
                                                  const std::filesystem::path& shader_root) {
  suite.setShaderRoot(shader_root);
  std::map<std::string, std::string> said;
  for (const std::string& check : checksOf(test.file)) {
    said[check];
  }
  for (const SceneSource& source : test.sources) {
    const SceneRun run = suite.run(test.file, source);
    for (const CheckResult& check : run.checks) {
      std::string& complaint = said[check.id];
      if (isFailure(check.outcome) && complaint.empty()) {
        complaint = complaintOf(check);
      }
    }
  }
  return said;
}

}  // namespace ssrkit
