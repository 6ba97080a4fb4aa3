// How long a worker may take, and at what.
#pragma once

#include <chrono>
#include <string_view>

namespace ssrkit {

// What a worker is at, by its progress.
enum class JobPhase {
  kOther,    // loads, uploads, reads back
  kCompile,  // "compile PASS": the kit's own compiler; "build PASS": the driver's
  kRun,      // "draw PASS"
};
[[nodiscard]] JobPhase phaseOf(std::string_view progress);

struct JobLimits {
  std::chrono::milliseconds wall{120000};
  std::chrono::seconds cpu{240};             // of the worker process, all threads; at least 1
  std::chrono::milliseconds compile{60000};  // from one progress to the next, at a shader's compilation
  std::chrono::milliseconds run{60000};      // likewise, at the drawing of a pass
};

// How long a worker may be at this.
[[nodiscard]] std::chrono::milliseconds budgetOf(JobPhase phase, const JobLimits& limits);

}  // namespace ssrkit
