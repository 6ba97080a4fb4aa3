// Runs expectation files: scenes x sizes x devices, one job each, and judges what comes back.
#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "check/check_result.h"
#include "check/expectation.h"
#include "check/judge.h"
#include "check/ledger.h"
#include "check/subject.h"
#include "command/cell_run.h"
#include "command/extra_passes.h"
#include "command/golden_shelf.h"
#include "command/seen_answers.h"
#include "command/truth_lane.h"
#include "command/worker_pool.h"
#include "frame/gbuffer_files.h"
#include "frame/job.h"
#include "worker/supervisor.h"

namespace ssrkit {

// What is traced: a scene file or a G-buffer made by others, and the parameters that it is best traced with.
struct SceneSource {
  std::string name;
  std::filesystem::path file;
  std::shared_ptr<const GbufferFiles> gbuffer;
  std::string camera_name;
  TraceParameters defaults;
};

// All runs of one test over one scene.
struct SceneRun {
  const SceneSource* source = nullptr;
  std::deque<CellRun> cells;
  std::vector<Answer> answers;
  std::deque<SeenAnswer> seen_answers;    // that answers of changed views are held against
  std::vector<CheckResult> extra_checks;  // what jobs told that were drawn again
  std::vector<CheckResult> checks;
  Ledger ledger;  // of every two devices' answers, where it is wanted
};

struct SuiteOptions {
  std::filesystem::path shader_root;
  std::filesystem::path scenes_root;
  std::filesystem::path goldens_root;  // where the truth `golden` is looked up
  // The run's, where a test names none. "vk-lavapipe@1" is the device with one thread (Mesa's
  // LP_NUM_THREADS).
  std::vector<std::string> devices;
  std::vector<std::string> further_devices;  // those that tests name themselves
  Size size;                                 // the run's, where a test names none
  std::string mirror_material;
  std::optional<EnvironmentChoice> environment;
  std::vector<ShaderReplacement> replacements;
  bool tests_draw_different_passes = false;  // so that some jobs may draw none of the replaced ones
  JobLimits limits;
  // Into so many parts a test's rounds are divided. The jobs of a test take turns, part by part, so that what
  // they cost may be compared round by round also between devices and sizes.
  int parts = 1;
  // Traced after the stages, with each case's parameters.
  std::vector<PeerShader> peers;
  // Over the devices' own environment, for every worker.
  std::vector<std::pair<std::string, std::string>> environment_variables;
  bool always_oracle = false;
  bool wants_ledger = false;
  bool geometry_of_first_device = false;  // Oracle B too, over the first device's G-buffer
  ExtraPasses extra;                      // what every plain job is drawn again for
  std::string command;                    // what the user typed, for the rerun line
  bool tests_in_job_ids = false;          // "trace.bits clutter 64x36" instead of "clutter 64x36"
  std::function<void(const std::string&)> progress;
};

class Suite {
 public:
  // Starts no worker yet.
  [[nodiscard]] static Expected<std::unique_ptr<Suite>> create(SuiteOptions options);

  // Runs one test over one scene and judges it. A timing too noisy to judge is measured once more, longer.
  [[nodiscard]] SceneRun run(const TestFile& test, const SceneSource& source);

  // Identity and traits of every device of the run; the first that is absent is an error.
  [[nodiscard]] Expected<std::map<std::string, DeviceInfo>> devices() { return workers_.infos(); }

  // One device's, which is started for it.
  [[nodiscard]] Expected<DeviceInfo> device(const std::string& id) { return workers_.at(id, {}).info(); }

  // What failures name as the command that runs them again.
  void setCommand(std::string command) { options_.command = std::move(command); }
  // The same, by the device whose answer failed.
  void setCommand(std::function<std::string(const std::string& device)> command_of) {
    command_of_ = std::move(command_of);
  }

  // What plain jobs are drawn again for from here on.
  void setExtraPasses(ExtraPasses passes) { options_.extra = std::move(passes); }

  // Jobs from here on are compiled from these shaders; the workers stay.
  void setShaderRoot(std::filesystem::path root) { options_.shader_root = std::move(root); }

  // A built-in scene by name, or any file, with the parameters of the TOML beside it.
  [[nodiscard]] static Expected<SceneSource> source(const std::string& name_or_path,
                                                    const std::filesystem::path& scenes_root);

 private:
  explicit Suite(SuiteOptions options) : options_(std::move(options)) {}
  void addExtraPasses(const TestFile& test, const Job& job, CellRun& cell, SceneRun& run);
  [[nodiscard]] DeviceConcerns concernsOf(const std::string& device);
  [[nodiscard]] SceneRun runOnce(const TestFile& test, const SceneSource& source);
  [[nodiscard]] WantedTruths wantedOf(const TestFile& test, const SceneSource& source, bool is_first) const;
  void runSize(const TestFile& test, const SceneSource& source, Size size, TruthLane& truths, SceneRun& run);
  void runAgain(const TestFile& test, const SceneSource& source, int part, SceneRun& run);
  void runCell(const TestFile& test, const std::string& device, const Job& job, const std::string& input,
               SceneRun& run);
  void runOverInput(const TestFile& test, const std::vector<std::string>& devices, Job job, SceneRun& run);
  void judge(const TestFile& test, const SceneSource& source, SceneRun& run);
  [[nodiscard]] GoldenLookup goldenLookup(GoldenShelf& shelf);

  [[nodiscard]] std::string commandFor(const std::string& device) const {
    return command_of_ ? command_of_(device) : options_.command;
  }

  SuiteOptions options_;
  std::function<std::string(const std::string& device)> command_of_;
  WorkerPool workers_;
};

}  // namespace ssrkit
