#include "command/run_request.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>

#include "base/check.h"
#include "base/size.h"
#include "check/read_expectations.h"
#include "command/device_threads.h"
#include "command/parameters_file.h"
#include "frame/frames.h"
#include "frame/stages.h"
#include "frame/technique_in_frame.h"
#include "frame/techniques.h"
#include "scene/find_scene.h"

namespace ssrkit {

namespace {

// Each pass is drawn this often after its first, cold time; the table shows the median.
constexpr int kTimedRounds = 2;

std::vector<std::string> withoutRepeats(const std::vector<std::string>& words) {
  std::vector<std::string> kept;
  for (const std::string& word : words) {
    if (std::ranges::find(kept, word) == kept.end()) {
      kept.push_back(word);
    }
  }
  return kept;
}

Expected<std::vector<SceneSource>> sources(const RunOptions& options, const KitPaths& paths) {
  std::vector<SceneSource> list;
  if (!options.gbuffer.empty()) {
    if (!options.scenes.empty()) {
      return inputError("run", "--gbuffer and --scene were both given", "", "trace one or the other");
    }
    auto files = readGbuffer(options.gbuffer);
    if (!files) {
      return tl::make_unexpected(files.error());
    }
    const auto parameters = parametersBesideCamera(options.gbuffer);
    if (!parameters) {
      return tl::make_unexpected(parameters.error());
    }
    const std::string name = files->name;
    list.push_back({.name = name,
                    .file = {},
                    .gbuffer = std::make_shared<GbufferFiles>(std::move(*files)),
                    .camera_name = "",
                    .defaults = *parameters});
    return list;
  }
  std::set<std::string> names;
  for (const std::string& scene : options.scenes.empty() ? builtInScenes(paths.scenes) : options.scenes) {
    auto source = Suite::source(scene, paths.scenes);
    if (!source) {
      return tl::make_unexpected(source.error());
    }
    source->camera_name = options.camera;
    if (!names.insert(source->name).second) {
      return inputError("run", fmt::format("two scenes are called '{}'", source->name), scene,
                        "their files would overwrite each other, run them one by one");
    }
    list.push_back(std::move(*source));
  }
  return list;
}

// The one asked for, else the one that the first technique with a frame of its own needs.
Expected<const FrameKind*> chooseFrame(const RunOptions& options) {
  if (!options.frame.empty()) {
    return findFrameKind(options.frame);
  }
  for (const std::string& name : options.techniques) {
    const auto technique = findTechnique(name);
    if (!technique) {
      return tl::make_unexpected(technique.error());
    }
    if (!(*technique)->frame.empty()) {
      return findFrameKind((*technique)->frame);
    }
  }
  return &frameKinds().front();
}

// Makes one case of each technique.
Expected<void> chooseTechniques(const RunOptions& options, TestFile& test) {
  const auto kind = chooseFrame(options);
  if (!kind) {
    return tl::make_unexpected(kind.error());
  }
  test.frame = (*kind)->name;
  for (const std::string& name : withoutRepeats(options.techniques)) {
    const auto technique = findTechnique(name);
    const auto drawn = technique ? inFrame(**technique, **kind) : tl::make_unexpected(technique.error());
    if (!drawn) {
      return tl::make_unexpected(drawn.error());
    }
    TestCase test_case = test.cases.front();
    test_case.name = name;
    test_case.technique = name;
    test.cases.push_back(std::move(test_case));
  }
  if (options.techniques.empty()) {
    test.cases.front().technique = (*kind)->technique;
    return {};
  }
  test.cases.erase(test.cases.begin());
  for (Expectation& expectation : test.expectations) {
    expectation.cases = withoutRepeats(options.techniques);
  }
  return {};
}

Expected<TestFile> standardTest(const RunOptions& options, const KitPaths& paths) {
  auto files = loadExpectations(paths.expectations / "standard.toml");
  if (!files) {
    return tl::make_unexpected(files.error());
  }
  TestFile test = std::move(files->front());
  test.stages = withoutRepeats(options.stages);
  for (const std::string& stage : test.stages) {
    if (const auto found = findStage(stage); !found) {
      return tl::make_unexpected(found.error());
    }
  }
  test.rounds = kTimedRounds;
  test.frames = options.frames;
  test.time_s = options.time_s;
  test.time_step_s = options.time_step_s;
  test.cases = {TestCase{}};
  TraceParameters scratch;
  for (const std::string& assignment : options.parameters) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos) {
      return inputError("read --param", fmt::format("'{}' is not NAME=VALUE", assignment), "--param");
    }
    const std::string name = assignment.substr(0, equals);
    const std::string value = assignment.substr(equals + 1);
    if (const auto set = setParameter(scratch, name, value, "--param"); !set) {
      return tl::make_unexpected(set.error());
    }
    test.cases.front().parameters.emplace_back(name, value);
  }
  if (isThicknessRelativeAlone(test.cases.front().parameters)) {
    test.cases.front().parameters.emplace_back("thickness_m", "0");
  }
  if (const auto chosen = chooseTechniques(options, test); !chosen) {
    return tl::make_unexpected(chosen.error());
  }
  return test;
}

Expected<std::vector<ShaderReplacement>> replacements(const RunOptions& options) {
  std::vector<ShaderReplacement> list;
  for (const std::string& assignment : options.replacements) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == assignment.size()) {
      return inputError("read --replace", fmt::format("'{}' is not PASS=FILE", assignment), "--replace");
    }
    list.push_back({.pass = assignment.substr(0, equals), .file = assignment.substr(equals + 1)});
  }
  return list;
}

Expected<std::optional<EnvironmentChoice>> environment(const RunOptions& options, const TestFile& test) {
  if (options.environment.empty()) {
    return std::nullopt;
  }
  const auto kind = findFrameKind(test.frame);
  if (kind && !(*kind)->has_environment) {
    return inputError("run", fmt::format("the frame '{}' has no environment", test.frame), "--environment",
                      "add --frame full");
  }
  std::error_code ignored;
  return parseEnvironment(options.environment, std::filesystem::current_path(ignored), "--environment")
      .map([](EnvironmentChoice choice) { return std::optional(std::move(choice)); });
}

Expected<Size> readSize(const std::string& text) {
  const std::optional<Size> size = parseSize(text);
  return size ? Expected<Size>(*size)
              : inputError(
                    "read the size",
                    fmt::format("'{}' is not WIDTHxHEIGHT with sides from 1 to {}", text, kMaxImageSide),
                    "--size", "write for example --size 640x360");
}

}  // namespace

Expected<RunRequest> readRequest(const RunOptions& options, const KitPaths& paths) {
  if (!options.extra.validate.empty() && std::ranges::none_of(options.devices, isVulkanDevice)) {
    return inputError("validate", "none of the devices is a Vulkan one", "--validate",
                      "add --device vk-lavapipe");
  }
  const auto size = readSize(options.size);
  auto test = size ? standardTest(options, paths) : tl::make_unexpected(size.error());
  auto replaced = test ? replacements(options) : tl::make_unexpected(test.error());
  auto lit_by = replaced ? environment(options, *test) : tl::make_unexpected(replaced.error());
  auto scenes = lit_by ? sources(options, paths) : tl::make_unexpected(lit_by.error());
  if (!scenes) {
    return tl::make_unexpected(scenes.error());
  }
  for (SceneSource& source : *scenes) {
    for (const auto& [name, value] : test->cases.front().parameters) {
      SSRKIT_CHECK(setParameter(source.defaults, name, value, "--param").has_value());
    }
  }
  return RunRequest{.size = *size,
                    .test = std::move(*test),
                    .scenes = std::move(*scenes),
                    .devices = withoutRepeats(options.devices),
                    .replacements = std::move(*replaced),
                    .environment = std::move(*lit_by)};
}

}  // namespace ssrkit
