// How a worker came to its end in the middle of a job, in words.
#pragma once

#include <string>
#include <vector>

#include "worker/child_process.h"
#include "worker/job_limits.h"

namespace ssrkit {

// The worker died or stopped answering in the middle of a job.
struct WorkerDeath {
  enum class Kind { kCrash, kTimeout };
  Kind kind = Kind::kCrash;
  int signal = 0;  // that ended it: SIGKILL for the wall limit, SIGXCPU for the CPU limit, 0 for none
  std::string last_progress;  // what it had begun
  std::string stderr_tail;    // the last lines it wrote; without a signal, a last line says how it ended
  JobPhase phase = JobPhase::kOther;  // of last_progress
};

// Of a child that ended so. `note` says what it did where that is known; "" where it is not.
[[nodiscard]] WorkerDeath deathFrom(WorkerDeath::Kind kind, const ChildEnd& end, std::string last_progress,
                                    std::string stderr_tail, const std::string& note);

// "its worker process died of signal 11 (Segmentation fault) in 'draw trace_hiz'".
[[nodiscard]] std::string describe(const WorkerDeath& death);

// At most twenty of the lines that it wrote last.
[[nodiscard]] std::vector<std::string> lastLines(const std::string& text);

}  // namespace ssrkit
