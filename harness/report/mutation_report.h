// What `mutate` found out of mutants, wheats and checks, as plain data.
#pragma once

#include <string>
#include <vector>

#include "mutation/kill_matrix.h"

namespace ssrkit {

struct MutationReport {
  std::string kit_version;
  std::string started;               // UTC, ISO 8601
  std::vector<std::string> command;  // argv
  std::vector<MutantRun> runs;
  std::vector<std::string> suite;  // the checks that are questioned when they notice nothing
  // Every mutant against every check that concerns it: only then do idle checks and copies mean anything.
  bool is_whole = false;
  double time_s = 0.0;
};

// Mutants first, by name, then wheats.
[[nodiscard]] std::vector<MutantRun> inOrder(std::vector<MutantRun> runs);

// One mutant or wheat as it comes out: a line or two of at most 100 columns.
[[nodiscard]] std::string mutantText(const MutantRun& run);

// The kill matrix, check by check, and the score.
[[nodiscard]] std::string mutationText(const MutationReport& report);

// DIR/mutate.json (docs/formats.md).
inline constexpr int kMutationSchemaVersion = 1;
[[nodiscard]] std::string mutationJson(const MutationReport& report);

// DIR/kill_matrix.csv: a row a mutant or wheat, a column a check; 1 noticed, 0 did not, empty: does not look
// at it.
[[nodiscard]] std::string killMatrixCsv(const MutationReport& report);

// DIR/report.html: the matrix as a table, in one file that opens from the disk.
[[nodiscard]] std::string mutationHtml(const MutationReport& report);

}  // namespace ssrkit
