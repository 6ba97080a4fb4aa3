// --compile-limit and --run-limit, of every command that draws other people's shaders.
#pragma once

#include "worker/job_limits.h"

namespace CLI {
class App;
}  // namespace CLI

namespace ssrkit {

struct LimitOptions {
  double compile_s = 60.0;  // for one pass's shader
  double run_s = 60.0;      // for one pass's drawing

  // With limits of the whole job that leave room for one pass at its own.
  [[nodiscard]] JobLimits jobLimits() const;
};

// `options` must outlive the parsing.
void addLimits(CLI::App& command, LimitOptions& options);

}  // namespace ssrkit
