// What became of one cell, as it is kept on disk.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "check/check_result.h"
#include "check/ledger.h"

namespace ssrkit {

struct CellRecord {
  std::string id;       // cellId
  std::string inputs;   // a hash of everything that decides the answers: equal inputs, equal answers
  double time_s = 0.0;  // of the worker, over all attempts
  int attempts = 1;     // runs of the cell: more than 1 after a failure or with --repeat
  std::vector<CheckResult> checks;
  Ledger ledger;  // of the pairs of devices whose second is the cell's
};

// The gravest outcome of the cell's checks: crash and timeout before fail, failures before doubts, doubts
// before pass; skip only where everything was skipped, missing without any check.
[[nodiscard]] Outcome outcomeOf(const CellRecord& record);
[[nodiscard]] Outcome gravestOutcome(const std::vector<CheckResult>& checks);

// The page shows the first hundred failures of a run in pictures: the maps of a broken driver's ten thousand
// cells would fill the memory. Drops the record's maps beyond those; `kept` counts them over the run.
void dropMaps(CellRecord& record, std::size_t& kept);

// One JSON object a file (docs/formats.md); numbers survive with every bit.
[[nodiscard]] std::string toJson(const CellRecord& record);

// Fails on anything that toJson did not write; `file` is for the message.
[[nodiscard]] Expected<CellRecord> readCellRecord(std::string_view json, const std::string& file);

}  // namespace ssrkit
