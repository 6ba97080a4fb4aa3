// The work of a `conform`: cells that are still to run, divided among lanes.
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "command/conform.h"
#include "command/conform_lane.h"
#include "command/conform_plan.h"
#include "command/progress_line.h"
#include "conform/cell_record.h"
#include "conform/cell_store.h"
#include "conform/manifest.h"

namespace ssrkit {

// Everything of a run that its lanes share.
struct ConformRun {
  const ConformOptions* options;
  const ConformPlan* plan;
  CellStore store;
  Manifest manifest;
  std::map<std::string, std::string> inputs;  // by cell id
  std::map<std::string, CellRecord> records;  // likewise, those that are finished
  std::vector<std::vector<Cell>> groups;      // still to run
  ProgressLine progress;
  std::mutex mutex;  // of records, progress and failure
  std::size_t failed = 0;
  std::size_t finding_maps = 0;          // kept in records
  std::optional<Error> failure;          // that ended the run
  std::optional<Error> required_absent;  // why a device is not there that must be
};

// Takes over what an earlier run finished, notes what an absent device was to do, and leaves the rest in
// groups.
[[nodiscard]] Expected<void> divideWork(ConformRun& run);

// Runs all groups in `lanes` threads and keeps each record as it comes. The first thing that cannot be
// written ends the run, with what was kept still in place.
[[nodiscard]] Expected<void> workThrough(ConformRun& run, const MakeSuite& make_suite, int lanes);

}  // namespace ssrkit
