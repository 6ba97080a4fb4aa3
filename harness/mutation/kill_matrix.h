// Which check noticed which mutant, and what that says of mutants and checks.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "mutation/mutant.h"

namespace ssrkit {

struct MutantRun {
  Mutant mutant;
  std::map<std::string, bool> noticed;      // by the check's name: whether it failed
  std::map<std::string, std::string> said;  // one line of what a check that failed said
  std::string problem;                      // why it could not be run; empty
  double time_s = 0.0;
};

// The names of the checks that failed.
[[nodiscard]] std::vector<std::string> killersOf(const MutantRun& run);

// A mutant that no check noticed, a wheat that one did, and either that could not be run or that no check
// looked at.
[[nodiscard]] bool isFailure(const MutantRun& run);

struct KillSummary {
  std::size_t mutants = 0;
  std::size_t killed = 0;
  std::size_t wheats = 0;
  std::size_t rejected = 0;
  std::vector<std::string> survivors;            // mutants that no check noticed
  std::vector<std::string> unexpected_killers;   // mutants that another check noticed than the one foretold
  std::vector<std::vector<std::string>> copies;  // checks that noticed the very same mutants, at least one
  std::vector<std::string> idle;                 // checks that noticed none
  std::map<std::string, std::vector<std::string>> kills;  // mutants by the check that noticed them
  std::vector<std::string> needed;                        // checks without which some mutant would live
};

// `suite`: the checks that are held against each other as copies, and named when they notice nothing.
[[nodiscard]] KillSummary summarise(const std::vector<MutantRun>& runs,
                                    const std::vector<std::string>& suite);

}  // namespace ssrkit
