// What a `conform` or a `conform merge` prints and writes of its records.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "check/baseline.h"
#include "command/kit_paths.h"
#include "conform/cell_record.h"
#include "conform/manifest.h"

namespace ssrkit {

struct ConformReport {
  Manifest manifest;
  std::vector<CellRecord> records;  // in the plan's order
  std::vector<std::string> notes;   // one sentence each
  std::vector<KnownFailure> known_failures;
  bool is_whole = false;  // nothing was left out: a known failure that fits no check is worth a note
  std::vector<std::string> command;
  std::filesystem::path out;
  bool json = false;
  std::optional<Error> failure;  // of the set-up, although cells were run: told before the closing line
};

// The list that `file` holds, or the kit's own where it is empty.
[[nodiscard]] Expected<std::vector<KnownFailure>> readKnownFailures(const std::filesystem::path& file,
                                                                    const KitPaths& paths);

// Judges the checks again by what is known to fail, writes results.json and the other files of a run, prints
// the table, the failures and the closing line, or the JSON. Gives the exit code: the failure's where there
// is one.
[[nodiscard]] Expected<int> finishConform(ConformReport report);

}  // namespace ssrkit
