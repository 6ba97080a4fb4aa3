#include "mutation/kill_matrix.h"

#include <algorithm>
#include <set>

namespace ssrkit {

std::vector<std::string> killersOf(const MutantRun& run) {
  std::vector<std::string> killers;
  for (const auto& [check, has_noticed] : run.noticed) {
    if (has_noticed) {
      killers.push_back(check);
    }
  }
  return killers;
}

bool isFailure(const MutantRun& run) {
  return !run.problem.empty() || run.noticed.empty() || killersOf(run).empty() != run.mutant.is_wheat;
}

namespace {

// Counts one run, and notes what its killers killed.
void addRun(const MutantRun& run, KillSummary& summary) {
  const std::vector<std::string> killers = killersOf(run);
  if (run.mutant.is_wheat) {
    if (run.mutant.edit.file.empty()) {
      return;  // the kit itself, which is nobody's change
    }
    ++summary.wheats;
    summary.rejected += killers.empty() ? 0U : 1U;
    return;
  }
  ++summary.mutants;
  if (killers.empty()) {
    summary.survivors.push_back(run.mutant.name);
    return;
  }
  ++summary.killed;
  if (std::ranges::find(killers, run.mutant.killed_by) == killers.end()) {
    summary.unexpected_killers.push_back(run.mutant.name);
  }
  for (const std::string& check : killers) {
    summary.kills[check].push_back(run.mutant.name);
  }
  if (killers.size() == 1 && std::ranges::find(summary.needed, killers.front()) == summary.needed.end()) {
    summary.needed.push_back(killers.front());
  }
}

}  // namespace

KillSummary summarise(const std::vector<MutantRun>& runs, const std::vector<std::string>& suite) {
  KillSummary summary;
  for (const MutantRun& run : runs) {
    addRun(run, summary);
  }
  std::map<std::vector<std::string>, std::vector<std::string>> by_kills;
  for (const std::string& check : std::set<std::string>(suite.begin(), suite.end())) {
    const auto kills = summary.kills.find(check);
    if (kills == summary.kills.end()) {
      summary.idle.push_back(check);
    } else {
      by_kills[kills->second].push_back(check);
    }
  }
  for (auto& [kills, checks] : by_kills) {
    if (checks.size() > 1) {
      summary.copies.push_back(std::move(checks));
    }
  }
  std::ranges::sort(summary.needed);
  return summary;
}

}  // namespace ssrkit
