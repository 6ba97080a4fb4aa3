// `ssrkit run`: traces scenes with every stage on every device, checks the answers, writes files and prints a
// table.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "command/limit_options.h"
#include "conform/extra_tests.h"

namespace ssrkit {

struct RunOptions {
  std::vector<std::string> scenes;  // built-in names or files; empty: all built-in scenes
  std::vector<std::string> stages{"naive", "refined", "dda", "hiz"};
  std::vector<std::string> devices{"gl-osmesa", "vk-lavapipe"};
  std::string frame;                    // a row of frame/frames.h; empty: what the techniques need
  std::vector<std::string> techniques;  // rows of frame/techniques.h; empty: the frame's own
  std::optional<int> frames;            // of a sequence; absent: as many as the techniques want
  std::optional<double> time_s;         // of the last frame; absent: the first is at 0 s
  std::optional<double> time_step_s;
  std::string size = "640x360";
  std::vector<std::string> parameters;  // "thickness_m=0.3"
  std::filesystem::path out = "out/run";
  std::string camera;
  std::string mirror;
  std::string environment;                // "constant:R,G,B" or an EXR file; empty: the scene's own
  std::filesystem::path gbuffer;          // a folder; then no scene is rendered
  std::vector<std::string> replacements;  // "trace_hiz=my.frag"
  ExtraPasses extra;
  LimitOptions limits;
  bool json = false;                 // results.json on standard output in the place of the table
  std::vector<std::string> command;  // argv, for the report
};

// The exit code of design section 6, after printing; errors that stop the run before it starts are returned.
[[nodiscard]] Expected<int> runCommand(const RunOptions& options);

}  // namespace ssrkit
