#include "command/run.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstring>
#include <ctime>
#include <future>
#include <memory>
#include <set>

#include "base/atomic_file.h"
#include "base/check.h"
#include "base/text.h"
#include "check/read_expectations.h"
#include "command/kit_paths.h"
#include "command/parameters_file.h"
#include "command/print_checks.h"
#include "command/progress_line.h"
#include "command/run_files.h"
#include "command/suite.h"
#include "frame/stages.h"
#include "report/results_json.h"
#include "report/table.h"
#include "scene/find_scene.h"

namespace ssrkit {

namespace {

// Each pass is drawn this often after its first, cold time; the table shows the median.
constexpr int kTimedRounds = 2;

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

// Leaves out what is not asked of the chosen stages, and what the parameters make untrue of a right tracer:
// strides and jitter let the DDA pass more than it leaks, and a budget ends the pyramid's tracer later than
// the walk.
void keepWhatIsAsked(TestFile& test, const TraceParameters& parameters) {
  const bool is_dense = parameters.stride_px == 1 && parameters.jitter == 0.0;
  const bool is_unlimited = parameters.lookup_budget == TraceParameters{}.lookup_budget;
  std::erase_if(test.expectations, [&](Expectation& expectation) {
    const bool against_oracle = expectation.truth.kind == TruthKind::kOracle;
    std::erase_if(expectation.stages, [&](const std::string& stage) {
      const bool is_chosen = std::ranges::find(test.stages, stage) != test.stages.end();
      return !is_chosen || (against_oracle && stage == "dda" && !(is_dense && is_unlimited)) ||
             (against_oracle && stage == "hiz" && !is_unlimited);
    });
    return expectation.stages.empty();
  });
}

std::vector<std::string> withoutRepeats(const std::vector<std::string>& words) {
  std::vector<std::string> kept;
  for (const std::string& word : words) {
    if (std::ranges::find(kept, word) == kept.end()) {
      kept.push_back(word);
    }
  }
  return kept;
}

// The built-in checks for any scene, with the stages and parameters that were asked for.
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

// Many ties are a property of a scene at a size (an unpitched mirror floor at a height of 4k + 2 rows has
// little else), not of a tracer: a run of anybody's scene is warned of them, the built-in tests are held to
// them.
void warnOfTies(std::vector<CheckResult>& checks) {
  for (CheckResult& check : checks) {
    if (check.metric == "ambiguous_share" && check.outcome == Outcome::kFail) {
      check.outcome = Outcome::kWarn;
    }
  }
}

// Fails before any work is done when nothing could be written afterwards.
Expected<void> prepareFolder(const std::filesystem::path& folder) {
  const std::string attempted = "write to the output folder";
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    return setupError(attempted, error.message(), folder.string(), "choose another one with --out");
  }
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    return setupError(attempted, std::strerror(errno), folder.string(), "choose another one with --out");
  }
  return {};
}

std::string utcNow() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}",
                     fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
}

// But for errors, which are told once on standard error.
void printFailures(const std::vector<CheckResult>& checks) {
  for (const CheckResult& check : checks) {
    if (isFailure(check.outcome) && check.outcome != Outcome::kError) {
      fmt::print("\n");
      printCheck(check);
    }
  }
}

// 2 or 3 when a scene could not be run at all, for the reason that the first one gives.
int exitCodeOf(const RunReport& report, const std::optional<Error>& first_error) {
  std::vector<Outcome> outcomes;
  for (const CheckResult& check : report.checks) {
    outcomes.push_back(check.outcome);
  }
  return first_error ? exitCode(*first_error) : exitCode(outcomes);
}

void print(const RunReport& report, const RunOptions& options) {
  if (options.json) {
    fmt::print("{}", resultsJson(report));
    return;
  }
  fmt::print("{}", runTable(report.rows, {.colour = wantsColour(STDOUT_FILENO), .width = 100}));
  printFailures(report.checks);
  std::vector<Outcome> outcomes;
  for (const CheckResult& check : report.checks) {
    outcomes.push_back(check.outcome);
  }
  fmt::print("\nwritten to {}\n{}\n", options.out.string(), closingLine(outcomes));
}

}  // namespace

Expected<Size> parseSize(const std::string& text) {
  constexpr int kMaxSide = 16384;
  Size size;
  const char* const end = text.data() + text.size();
  const auto [after_width, width_error] = std::from_chars(text.data(), end, size.width);
  const bool has_separator = width_error == std::errc() && after_width != end && *after_width == 'x';
  const auto [after_height, height_error] = has_separator
                                                ? std::from_chars(after_width + 1, end, size.height)
                                                : std::from_chars_result{end, std::errc::invalid_argument};
  if (height_error != std::errc() || after_height != end || size.width < 1 || size.height < 1 ||
      size.width > kMaxSide || size.height > kMaxSide) {
    return inputError("read the size",
                      fmt::format("'{}' is not WIDTHxHEIGHT with sides from 1 to {}", text, kMaxSide),
                      "--size", "write for example --size 640x360");
  }
  return size;
}

Expected<int> runCommand(const RunOptions& options) {
  const KitPaths paths = kitPaths();
  const auto size = parseSize(options.size);
  auto test = size ? standardTest(options, paths) : tl::make_unexpected(size.error());
  auto replaced = test ? replacements(options) : tl::make_unexpected(test.error());
  auto scenes = replaced ? sources(options, paths) : tl::make_unexpected(replaced.error());
  if (!scenes) {
    return tl::make_unexpected(scenes.error());
  }
  for (SceneSource& source : *scenes) {
    for (const auto& [name, value] : test->cases.front().parameters) {
      SSRKIT_CHECK(setParameter(source.defaults, name, value, "--param").has_value());
    }
  }
  ProgressLine progress;
  auto suite = Suite::create({.shader_root = paths.shaders,
                              .scenes_root = paths.scenes,
                              .devices = withoutRepeats(options.devices),
                              .size = *size,
                              .mirror_material = options.mirror,
                              .replacements = *replaced,
                              .limits = {},
                              .want_images = true,
                              .always_oracle = true,
                              .command = fmt::format("{}", fmt::join(options.command, " ")),
                              .progress = [&](const std::string& text) { progress.show(text); }});
  if (!suite) {
    return tl::make_unexpected(suite.error());
  }
  if (const auto folder = prepareFolder(options.out); !folder) {
    return tl::make_unexpected(folder.error());
  }
  RunReport report{.kit_version = SSRKIT_VERSION, .started = utcNow(), .command = options.command};
  const auto infos = (*suite)->devices();
  if (!infos) {
    return tl::make_unexpected(infos.error());
  }
  for (const auto& [id, info] : *infos) {
    report.devices.push_back({info.identity, info.traits});
  }
  std::optional<Error> first_error;
  std::set<std::string> errors;
  std::future<Expected<void>> writing;
  const auto finishWriting = [&]() -> Expected<void> {
    return writing.valid() ? writing.get() : Expected<void>{};
  };
  std::set<std::string> notes;
  for (const SceneSource& source : *scenes) {
    TestFile asked = *test;
    keepWhatIsAsked(asked, source.defaults);
    auto run = std::make_shared<SceneRun>((*suite)->run(asked, source));
    warnOfTies(run->checks);
    std::vector<RunRow> rows = runRows(*run);
    for (const CellRun& cell : run->cells) {
      if (cell.error) {
        first_error = first_error.value_or(*cell.error);
        errors.insert(sentence(*cell.error));
      }
      if (cell.result) {
        report.frames.push_back({source.name, cell.device, cell.size, cell.result->frame_passes});
        for (const std::string& note : cell.result->notes) {
          notes.insert(fmt::format("{}: {}", source.name, note));
        }
      }
    }
    report.rows.insert(report.rows.end(), rows.begin(), rows.end());
    report.checks.insert(report.checks.end(), run->checks.begin(), run->checks.end());
    // The files of one scene are written while the next one is traced.
    if (const auto written = finishWriting(); !written) {
      return tl::make_unexpected(written.error());
    }
    writing = std::async(std::launch::async,
                         [run, rows, out = options.out] { return writeSceneFiles(out, *run, rows); });
  }
  progress.show("writing files");
  if (const auto written = finishWriting(); !written) {
    return tl::make_unexpected(written.error());
  }
  if (const auto written = writeResultsJson(options.out / "results.json", report); !written) {
    return tl::make_unexpected(written.error());
  }
  progress.clear();
  for (const std::string& note : notes) {
    fmt::print(stderr, "note: {}\n", note);
  }
  print(report, options);
  std::fflush(stdout);
  for (const std::string& error : errors) {
    fmt::print(stderr, "ssrkit: {}\n", error);
  }
  return exitCodeOf(report, first_error);
}

}  // namespace ssrkit
