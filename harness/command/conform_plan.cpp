#include "command/conform_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/check.h"
#include "check/read_expectations.h"
#include "command/device_threads.h"
#include "command/known_names.h"
#include "conform/extra_tests.h"
#include "conform/merge.h"
#include "conform/plan.h"
#include "device/registry.h"
#include "scene/find_scene.h"

namespace ssrkit {

namespace {

constexpr Size kDefaultSize{64, 36};

void addOnce(std::vector<std::string>& names, const std::string& added) {
  if (std::ranges::find(names, added) == names.end()) {
    names.push_back(added);
  }
}

// Real drivers are there on some machines only; the software ones can be had on all.
std::vector<std::string> softwareDevices() {
  std::vector<std::string> ids;
  for (const DeviceEntry& entry : deviceEntries()) {
    if (entry.is_software) {
      ids.push_back(entry.id);
    }
  }
  return ids;
}

Expected<void> chooseDevices(const ConformOptions& options, ConformPlan& plan) {
  for (const auto& names : {options.devices, options.optional_devices}) {
    for (const std::string& id : names) {
      if (const auto entry = findDevice(id); !entry) {
        return tl::make_unexpected(entry.error());
      }
    }
  }
  for (const std::string& id : options.optional_devices) {
    addOnce(plan.optional, id);
  }
  for (const std::string& id : options.devices.empty() ? softwareDevices() : options.devices) {
    // Of the default set some may be named optional; what is named as both is required.
    if (!options.devices.empty() || std::ranges::find(plan.optional, id) == plan.optional.end()) {
      addOnce(plan.required, id);
      std::erase(plan.optional, id);
    }
  }
  return {};
}

Expected<void> addSource(const std::string& name_or_path, const KitPaths& paths, ConformPlan& plan) {
  auto source = Suite::source(name_or_path, paths.scenes);
  if (!source) {
    return tl::make_unexpected(source.error());
  }
  const auto known = plan.sources.find(source->name);
  if (known != plan.sources.end() && known->second.file != source->file) {
    return inputError("plan the matrix", fmt::format("two scenes are called '{}'", source->name), "--scene",
                      "rename one of the files");
  }
  plan.sources.emplace(source->name, std::move(*source));
  return {};
}

// The scenes' names as cells have them.
Expected<std::vector<std::string>> chooseScenes(const ConformOptions& options, const KitPaths& paths,
                                                ConformPlan& plan) {
  std::vector<std::string> chosen;
  for (const std::string& scene : options.scenes) {
    if (const auto added = addSource(scene, paths, plan); !added) {
      return tl::make_unexpected(added.error());
    }
  }
  for (const auto& [name, source] : plan.sources) {
    chosen.push_back(name);
  }
  for (const std::string& scene : builtInScenes(paths.scenes)) {
    if (const auto added = plan.sources.contains(scene) ? Expected<void>{} : addSource(scene, paths, plan);
        !added) {
      return tl::make_unexpected(added.error());
    }
  }
  return chosen;
}

// A run of what failed before has the cells of that run.
Expected<void> addExtraTests(const ConformOptions& options, std::vector<std::string> devices,
                             ConformPlan& plan) {
  std::erase_if(devices, [](const std::string& device) { return !isVulkanDevice(device); });
  if (!options.extra.validate.empty() && devices.empty()) {
    return inputError("validate", "none of the devices is a Vulkan one", "--validate",
                      "add --device vk-lavapipe");
  }
  const ExtraPasses every{.safety = true, .validate = "core,sync,gpu"};
  std::vector<TestFile> extra =
      extraTests(plan.tests, options.rerun_failed.empty() ? options.extra : every, devices);
  std::ranges::move(extra, std::back_inserter(plan.tests));
  return {};
}

// Of the cells, those that failed or were never finished in an earlier run's folder.
Expected<std::vector<Cell>> keepFailed(std::vector<Cell> cells, const std::filesystem::path& folder) {
  const auto failed = failedCells(folder);
  if (!failed) {
    return tl::make_unexpected(failed.error());
  }
  std::erase_if(cells,
                [&](const Cell& cell) { return std::ranges::find(*failed, cellId(cell)) == failed->end(); });
  if (cells.empty()) {
    return inputError("run the failed cells again",
                      failed->empty() ? "no cell of it failed" : "none of its failed cells is selected",
                      folder.string());
  }
  return cells;
}

}  // namespace

const TestFile& ConformPlan::test(const Cell& cell) const {
  const auto found = std::ranges::find(tests, cell.test, &TestFile::id);
  SSRKIT_CHECK(found != tests.end());
  return *found;
}

Expected<ConformPlan> makePlan(const ConformOptions& options, const KitPaths& paths) {
  ConformPlan plan;
  const auto shard = parseShard(options.shard);
  auto tests = loadExpectations(paths.conformance, knownNames(paths));
  const auto chosen = chooseDevices(options, plan);
  const auto scenes = chooseScenes(options, paths, plan);
  if (!shard || !tests || !chosen || !scenes) {
    return tl::make_unexpected(!shard    ? shard.error()
                               : !tests  ? tests.error()
                               : !chosen ? chosen.error()
                                         : scenes.error());
  }
  plan.shard = *shard;
  plan.tests = std::move(*tests);
  std::vector<std::string> devices = plan.required;
  devices.insert(devices.end(), plan.optional.begin(), plan.optional.end());
  if (const auto added = addExtraTests(options, devices, plan); !added) {
    return tl::make_unexpected(added.error());
  }
  const MatrixAxes axes{.built_in_scenes = builtInScenes(paths.scenes),
                        .scenes = *scenes,
                        .devices = devices,
                        .size = kDefaultSize};
  auto cells = select(
      matrix(plan.tests, axes),
      {.filters = options.filters, .excludes = options.excludes, .shuffle_seed = options.shuffle_seed});
  if (cells && !options.rerun_failed.empty()) {
    cells = keepFailed(std::move(*cells), options.rerun_failed);
  }
  if (!cells) {
    return tl::make_unexpected(cells.error());
  }
  plan.cells = std::move(*cells);
  plan.own = cellsOfShard(plan.cells, plan.shard);
  return plan;
}

std::vector<std::string> referencesOf(const TestFile& test, const std::string& device) {
  std::vector<std::string> references;
  if (!test.input.empty()) {
    references.push_back(test.input);
  }
  for (const Expectation& expectation : test.expectations) {
    const bool is_asked =
        !expectation.devices || std::ranges::find(*expectation.devices, device) != expectation.devices->end();
    if (is_asked && expectation.truth.kind == TruthKind::kCross && expectation.truth.name != device) {
      addOnce(references, expectation.truth.name);
    }
  }
  return references;
}

std::vector<std::string> devicesOf(const ConformPlan& plan) {
  std::vector<std::string> devices;
  for (const Cell& cell : plan.own) {
    addOnce(devices, cell.device);
    for (const std::string& reference : referencesOf(plan.test(cell), cell.device)) {
      addOnce(devices, reference);
    }
  }
  return devices;
}

}  // namespace ssrkit
