#include "worker/job_limits.h"

namespace ssrkit {

JobPhase phaseOf(std::string_view progress) {
  if (progress.starts_with("compile ") || progress.starts_with("build ")) {
    return JobPhase::kCompile;
  }
  return progress.starts_with("draw ") ? JobPhase::kRun : JobPhase::kOther;
}

std::chrono::milliseconds budgetOf(JobPhase phase, const JobLimits& limits) {
  switch (phase) {
    case JobPhase::kCompile:
      return limits.compile;
    case JobPhase::kRun:
      return limits.run;
    case JobPhase::kOther:
      break;
  }
  return limits.wall;
}

}  // namespace ssrkit
