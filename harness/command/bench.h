// `ssrkit bench`: what every pass costs, in interleaved rounds, and whether it costs what it should.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"

namespace ssrkit {

struct BenchOptions {
  std::vector<std::string> scenes{"clutter", "corridor"};
  std::vector<std::string> stages{"naive", "refined", "dda", "hiz", "walk"};
  std::vector<std::string> devices{"gl-osmesa", "vk-lavapipe"};
  std::string size = "1280x720";
  std::vector<std::string> parameters;    // "thickness_m=0.3"
  std::vector<std::string> replacements;  // "trace_hiz=my.frag"
  std::optional<int> rounds;              // absent: 15, or what a gate's file says
  std::filesystem::path out = "out/bench";
  std::filesystem::path baseline;            // an earlier bench.json; empty: none
  std::vector<std::string> axes;             // of scaling
  std::vector<std::filesystem::path> peers;  // files that describe a shader of somebody's own
  bool rooflines = false;
  bool gates = false;
  bool json = false;                 // bench.json on standard output in the place of the tables
  std::vector<std::string> command;  // argv, for the report
};

// The axes of --scaling.
[[nodiscard]] std::vector<std::string> benchAxes();

// 0 when everything was measured; 1 when a gate fails, a pass got slower than the baseline's or something
// could not be measured; 4 when only the noise was too large to judge.
[[nodiscard]] Expected<int> benchCommand(const BenchOptions& options);

}  // namespace ssrkit
