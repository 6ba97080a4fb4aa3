#include "command/conform_options.h"

#include <CLI/CLI.hpp>

namespace ssrkit {

namespace {

using Command = std::function<Expected<int>()>;

void addConformMerge(CLI::App& conform, ConformMergeOptions& options, Command& command) {
  CLI::App* merge = conform.add_subcommand("merge", "Make the folders of shards one");
  merge->add_option("folder", options.folders, "The --out folder of each shard")->required();
  merge->add_option("--out", options.out, "The folder of the whole")->capture_default_str();
  merge->add_option("--baseline", options.baseline, "A list of known failures (default: the kit's own)");
  merge->add_flag("--json", options.json, "Print results.json instead of the table");
  merge->callback([&] { command = [&] { return conformMergeCommand(options); }; });
}

}  // namespace

void addConform(CLI::App& app, ConformOptions& options, ConformMergeOptions& merge, Command& command) {
  CLI::App* conform =
      app.add_subcommand("conform", "Hold every device against the oracle and each other, buffer by buffer");
  conform->add_option("--device", options.devices,
                      "A device that must be there (default: every software device of `ssrkit devices`)");
  conform->add_option("--optional", options.optional_devices, "A device that is skipped where it is absent");
  conform->add_option("--scene", options.scenes,
                      "A scene to keep, or a glTF file (default: each test's own)");
  conform->add_option(
      "--filter", options.filters,
      "Cells to run: a pattern of TEST/SCENE/WxH/DEVICE or of its beginning, * stands for any text");
  conform->add_option("--exclude", options.excludes, "Cells to leave out, likewise");
  conform->add_flag("--list", options.list, "Print the cells' ids instead of running them");
  conform->add_flag(
      "--safety", options.extra.safety,
      "Cells safety.TEST/... too: each job drawn again with indices clamped and with loops counted");
  conform
      ->add_option(
          "--validate", options.extra.validate,
          "Cells validate.CHECK.TEST/... too: each Vulkan job drawn under the validation layer, for a "
          "list of core, sync and gpu")
      ->check(problemWithChecks);
  addLimits(*conform, options.limits);
  conform->add_option("--shuffle", options.shuffle_seed, "Another order, by a seed");
  conform->add_option("--repeat", options.repeat, "Runs of each cell: what differs is a flake")
      ->check(CLI::Range(1, 1000));
  conform->add_option("--rerun-failed", options.rerun_failed,
                      "Only the cells that failed in this folder's run");
  conform->add_flag("--resume", options.resume, "Keep the results in the --out folder that still hold");
  conform->add_option("--shard", options.shard, "INDEX/COUNT: one part of the cells, always the same")
      ->capture_default_str();
  conform
      ->add_option("--jobs", options.jobs,
                   "Groups of cells that run at once (default: a processor each, at most 4)")
      ->check(CLI::Range(1, 64));
  conform->add_option("--out", options.out, "The folder for results.json and the cells")
      ->capture_default_str();
  conform->add_option("--baseline", options.baseline, "A list of known failures (default: the kit's own)");
  conform->add_flag("--json", options.json, "Print results.json instead of the table");
  // Called after a subcommand's own, too.
  conform->callback([&, conform] {
    if (conform->get_subcommands().empty()) {
      command = [&] { return conformCommand(options); };
    }
  });
  addConformMerge(*conform, merge, command);
}

}  // namespace ssrkit
