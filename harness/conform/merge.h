// Folders of shards, made one.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "conform/cell_record.h"
#include "conform/manifest.h"

namespace ssrkit {

struct Merged {
  Manifest manifest;  // of the whole: shard 1/1, the plan's cells in order
  std::vector<CellRecord>
      records;  // one a cell of the plan, in order; an unfinished one has one `missing` check
  std::vector<std::string>
      notes;  // each missing shard and how many cells of others are missing, one sentence each
};

// Fails when a folder is no conform folder, when folders belong to different plans or kits, and when a shard
// comes twice, naming the folders.
[[nodiscard]] Expected<Merged> merge(std::span<const std::filesystem::path> folders);

// A cell of the plan that has no result: one check, `missing`, with the reason.
[[nodiscard]] CellRecord missingCell(const std::string& id, const std::string& reason);

// The ids of a folder's cells that failed or were never finished.
[[nodiscard]] Expected<std::vector<std::string>> failedCells(const std::filesystem::path& folder);

}  // namespace ssrkit
