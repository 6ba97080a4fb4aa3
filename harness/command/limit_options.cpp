#include "command/limit_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

namespace ssrkit {

namespace {

std::chrono::milliseconds milliseconds(double seconds) {
  return std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::duration<double>(seconds));
}

}  // namespace

JobLimits LimitOptions::jobLimits() const {
  const JobLimits usual;
  const auto together = milliseconds(compile_s + run_s);
  return {.wall = std::max(usual.wall, together),
          .cpu = std::max(usual.cpu, std::chrono::ceil<std::chrono::seconds>(2 * together)),
          .compile = milliseconds(compile_s),
          .run = milliseconds(run_s)};
}

void addLimits(CLI::App& command, LimitOptions& options) {
  command.add_option("--compile-limit", options.compile_s, "Seconds that one pass's shader may compile")
      ->check(CLI::Range(0.1, 86400.0))
      ->capture_default_str();
  command.add_option("--run-limit", options.run_s, "Seconds that one pass may be drawn")
      ->check(CLI::Range(0.1, 86400.0))
      ->capture_default_str();
}

}  // namespace ssrkit
