#include "command/bless.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <iterator>

#include "base/text.h"
#include "check/judge.h"
#include "check/read_expectations.h"
#include "command/bless_candidates.h"
#include "command/bless_report.h"
#include "command/git_state.h"
#include "command/golden_shelf.h"
#include "command/kit_paths.h"
#include "command/known_names.h"
#include "command/print_checks.h"
#include "command/progress_line.h"
#include "command/suite.h"
#include "scene/find_scene.h"

namespace ssrkit {

namespace {

const std::string kAttemptedBless = "bless goldens";

bool isGolden(const Expectation& expectation) {
  return expectation.truth.kind == TruthKind::kGolden;
}

// Who blesses; or why nobody may.
Expected<std::string> blesser(const BlessOptions& options, const KitPaths& paths) {
  const char* const ci = std::getenv("CI");
  if (ci != nullptr && *ci != '\0') {
    return inputError(kAttemptedBless, "CI is set, and goldens are blessed by people", "CI",
                      "bless on your own machine, and commit what it writes");
  }
  if (options.why.find_first_not_of(" \t\n") == std::string::npos) {
    return inputError(kAttemptedBless, "there is no reason", "--why", "say why what is drawn now is right");
  }
  const auto changed = changedFiles(paths.root, {"shaders", "scenes"});
  if (changed && !changed->empty()) {
    return inputError(
        kAttemptedBless,
        fmt::format("{} is not committed{}, so that nobody could make these goldens again", changed->front(),
                    changed->size() > 1 ? fmt::format(", nor are {} more", changed->size() - 1) : ""),
        paths.root.string(), "commit shaders and scenes first");
  }
  if (!options.who.empty()) {
    return options.who;
  }
  const auto identity = gitIdentity(paths.root);
  return identity ? Expected<std::string>(*identity)
                  : inputError(kAttemptedBless, "git knows no name of yours", "--who", "add --who NAME");
}

Expected<TestFile> testWithGoldens(const BlessOptions& options, const KitPaths& paths) {
  const auto tests = loadExpectations(paths.expectations, knownNames(paths));
  if (!tests) {
    return tl::make_unexpected(tests.error());
  }
  std::vector<std::string> ids;
  for (const TestFile& test : *tests) {
    if (std::ranges::any_of(test.expectations, isGolden)) {
      ids.push_back(test.id);
    }
  }
  const auto found = std::ranges::find(*tests, options.test, &TestFile::id);
  if (found == tests->end() || std::ranges::find(ids, options.test) == ids.end()) {
    return inputError(kAttemptedBless, fmt::format("no test '{}' expects a golden", options.test), "",
                      ids.empty() ? "add truth = \"golden\" to an expectation file"
                                  : "those that do are " + joinNames(ids));
  }
  TestFile test = *found;
  if (!options.devices.empty()) {
    test.devices = options.devices;
  } else {
    test.devices = {test.devices.empty() ? "gl-osmesa" : test.devices.front()};
  }
  if (!options.scenes.empty()) {
    for (const std::string& scene : options.scenes) {
      if (test.scenes.front() != "all" && std::ranges::find(test.scenes, scene) == test.scenes.end()) {
        return inputError(kAttemptedBless, fmt::format("the test has no scene '{}'", scene), test.file,
                          "its scenes are " + joinNames(test.scenes));
      }
    }
    test.scenes = options.scenes;
  } else if (test.scenes.front() == "all") {
    test.scenes = builtInScenes(paths.scenes);
  }
  return test;
}

// What fails by another truth is wrong, and no golden makes it right.
Expected<void> requireProved(const TestFile& test, const SceneRun& run, bool json) {
  for (const CheckResult& check : run.checks) {
    const auto own = std::ranges::find_if(test.expectations, [&](const Expectation& expectation) {
      return check.id == test.id + "." + expectation.name;
    });
    if (isFailure(check.outcome) && (own == test.expectations.end() || !isGolden(*own))) {
      if (!json) {
        printCheck(check);
      }
      return inputError(kAttemptedBless,
                        fmt::format("'{}' fails, so that what is drawn is wrong", fullName(check)), test.file,
                        "mend it first");
    }
  }
  return {};
}

Expected<std::vector<BlessedGolden>> blessScene(Suite& suite, const TestFile& test, const SceneSource& source,
                                                const Blessing& blessing, const KitPaths& paths, bool json) {
  const SceneRun run = suite.run(test, source);
  if (auto proved = requireProved(test, run, json); !proved) {
    return tl::make_unexpected(proved.error());
  }
  const auto devices = suite.devices();
  if (!devices) {
    return tl::make_unexpected(devices.error());
  }
  const auto shelf = GoldenShelf::load(paths.goldens, test, source.name);
  if (!shelf) {
    return tl::make_unexpected(shelf.error());
  }
  const auto candidates = blessCandidates(test, run, *devices, blessing, paths);
  if (!candidates) {
    return tl::make_unexpected(candidates.error());
  }
  std::vector<BlessedGolden> blessed;
  for (const Golden& golden : *candidates) {
    blessed.push_back({.note = golden.note,
                       .file = goldenFile(paths.goldens, golden.note).lexically_relative(paths.root),
                       .change = changeText(golden, shelf->goldens())});
    if (!json) {
      fmt::print("{}\n", blessed.back().change);
    }
    if (auto written = writeGolden(paths.goldens, golden); !written) {
      return tl::make_unexpected(written.error());
    }
  }
  return blessed;
}

}  // namespace

Expected<int> blessCommand(const BlessOptions& options) {
  const KitPaths paths = kitPaths();
  const auto test = testWithGoldens(options, paths);
  if (!test) {
    return tl::make_unexpected(test.error());
  }
  const auto who = blesser(options, paths);
  if (!who) {
    return tl::make_unexpected(who.error());
  }
  ProgressLine progress;
  auto suite = Suite::create({.shader_root = paths.shaders,
                              .scenes_root = paths.scenes,
                              .goldens_root = paths.goldens,
                              .devices = test->devices,
                              .size = {160, 90},
                              .progress = [&](const std::string& text) { progress.show(text); }});
  if (!suite) {
    return tl::make_unexpected(suite.error());
  }
  const Blessing blessing{.who = *who,
                          .when = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))),
                          .why = options.why};
  std::vector<BlessedGolden> all;
  for (const std::string& scene : test->scenes) {
    const auto source = Suite::source(scene, paths.scenes);
    auto blessed = source ? blessScene(**suite, *test, *source, blessing, paths, options.json)
                          : tl::make_unexpected(source.error());
    progress.clear();
    if (!blessed) {
      return tl::make_unexpected(blessed.error());
    }
    std::ranges::move(*blessed, std::back_inserter(all));
  }
  if (options.json) {
    fmt::print("{}", blessJson(test->id, all));
    return 0;
  }
  fmt::print("{} goldens blessed by {}; look at the pictures, then commit {}\n", all.size(), *who,
             (paths.goldens / test->id).lexically_relative(paths.root).string());
  return 0;
}

}  // namespace ssrkit
