#include "command/run_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>

#include "base/text.h"
#include "command/limit_options.h"
#include "conform/extra_tests.h"
#include "frame/stages.h"

namespace ssrkit {

namespace {

// Every tracer with its line for people.
std::string stageList() {
  std::string list = "Stages:\n";
  for (const Stage& stage : stages()) {
    list += fmt::format("  {:26}{}\n", stage.name, stage.about);
  }
  return list;
}

}  // namespace

void addRun(CLI::App& app, RunOptions& options, std::function<Expected<int>()>& command) {
  CLI::App* run = app.add_subcommand("run", "Trace scenes, check the answers, write files and a table");
  run->add_option("--scene", options.scenes,
                  "A built-in scene or a glTF 2.0 file (default: all built-in scenes)");
  run->add_option("--stage", options.stages,
                  fmt::format("A tracer of the list below (default: {})", joinNames(options.stages)));
  run->add_option("--frame", options.frame,
                  "basic: one light and the reflections; full: every pass of the kit (default: what the "
                  "techniques need)");
  run->add_option("--technique", options.techniques,
                  "How a picture is made of the rays (default: the frame's own)");
  run->add_option("--time", options.time_s,
                  "Seconds of the scene's animation, for the last frame (default: the first frame is at 0)")
      ->check(CLI::Range(-1e6, 1e6));
  run->add_option("--frames", options.frames,
                  "Frames to draw, the last one is shown and checked (default: what the techniques want)")
      ->check(CLI::Range(1, 1000));
  run->add_option("--time-step", options.time_step_s, "Seconds between two frames (default: 1/30)")
      ->check(CLI::Range(0.0, 1e6));
  run->add_option("--device", options.devices,
                  "A device of `ssrkit devices` (default: gl-osmesa and vk-lavapipe)");
  CLI::Option* const size =
      run->add_option("--size", options.size, "WIDTHxHEIGHT in texels")->capture_default_str();
  run->add_option("--param", options.parameters,
                  "NAME=VALUE of the tracing parameters, for example thickness_m=0.3");
  run->add_option("--out", options.out, "The folder for results.json, EXR and PNG files")
      ->capture_default_str();
  CLI::Option* const camera =
      run->add_option("--camera", options.camera, "A camera of the scene by name (default: its first)");
  CLI::Option* const mirror = run->add_option(
      "--mirror", options.mirror, "The material to trace rays from (default: the scene's own mirrors)");
  run->add_option("--environment", options.environment,
                  "What lights the full frame from outside: constant:R,G,B, or an equirectangular EXR file "
                  "(default: the scene's own)")
      ->check([](const std::string& text) { return text.empty() ? "it names no environment" : ""; });
  run->add_option(
         "--gbuffer", options.gbuffer,
         "Trace the G-buffer in this folder (EXR images and camera.json), which has a size, a camera "
         "and mirrors of its own")
      ->check([](const std::string& folder) { return folder.empty() ? "it names no folder" : ""; })
      ->excludes(size, camera, mirror);
  run->add_option("--replace", options.replacements, "PASS=FILE: put a shader of your own in a pass's place");
  run->add_flag("--safety", options.extra.safety,
                "Draw everything again with indices clamped and with loops counted, and compare: finds reads "
                "outside arrays and loops that drivers cut short");
  run->add_option("--validate", options.extra.validate,
                  "Draw everything again under Vulkan's validation layer: a list of core, sync and gpu; each "
                  "message is a failure")
      ->check(problemWithChecks);
  addLimits(*run, options.limits);
  run->add_flag("--json", options.json, "Print results.json instead of the table");
  run->footer(stageList());
  run->callback([&] { command = [&] { return runCommand(options); }; });
}

}  // namespace ssrkit
