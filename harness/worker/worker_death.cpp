#include "worker/worker_death.h"

#include <fmt/format.h>

#include <csignal>
#include <cstring>
#include <utility>

#include "base/text.h"
#include "worker/serve.h"

namespace ssrkit {

WorkerDeath deathFrom(WorkerDeath::Kind kind, const ChildEnd& end, std::string last_progress,
                      std::string stderr_tail, const std::string& note) {
  const JobPhase phase = phaseOf(last_progress);
  WorkerDeath death{kind, end.signal, std::move(last_progress), std::move(stderr_tail), phase};
  if (end.signal == SIGXCPU) {
    death.kind = WorkerDeath::Kind::kTimeout;
  }
  if (death.kind == WorkerDeath::Kind::kTimeout) {
    return death;
  }
  std::string last_line = note;
  const bool went_on = end.was_killed || (end.signal == 0 && end.exit_code == kAbandoned);
  if (went_on) {
    death.signal = 0;  // ours, and not the cause
    last_line = note.empty() ? "the worker closed its socket and went on" : note;
  } else if (end.signal == 0) {
    last_line = fmt::format("the worker exited with code {} before it answered", end.exit_code);
  }
  if (!last_line.empty()) {
    const bool needs_newline = !death.stderr_tail.empty() && death.stderr_tail.back() != '\n';
    death.stderr_tail += (needs_newline ? "\n" : "") + last_line + "\n";
  }
  return death;
}

std::string describe(const WorkerDeath& death) {
  std::string text = "its worker process ";
  if (death.kind == WorkerDeath::Kind::kTimeout) {
    text += "gave no answer in time";
  } else if (death.signal != 0) {
    const char* const description = sigdescr_np(death.signal);
    text += fmt::format("died of signal {} ({})", death.signal, description ? description : "unknown");
  } else {
    text += "ended";
  }
  return death.last_progress.empty() ? text : text + " in '" + death.last_progress + "'";
}

std::vector<std::string> lastLines(const std::string& text) {
  std::vector<std::string> lines = split(text, '\n');
  std::erase(lines, "");
  constexpr std::size_t kMostLines = 20;
  if (lines.size() > kMostLines) {
    lines.erase(lines.begin(), lines.end() - kMostLines);
  }
  return lines;
}

}  // namespace ssrkit
