// What one folder of results was to hold: written before the first cell runs, so that whoever finds the
// folder later knows what is missing.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "conform/shard.h"
#include "report/run_report.h"

namespace ssrkit {

struct Manifest {
  std::string kit_version;
  std::string started;               // UTC, ISO 8601
  std::vector<std::string> command;  // argv
  Shard shard;
  std::vector<std::string> cells;  // ids of the whole plan, all shards', in its order
  std::vector<int> shard_of_cell;  // one a cell
  std::vector<DeviceRow> devices;
  std::vector<std::pair<std::string, std::string>> absent;  // devices that are not there, and why
};

[[nodiscard]] std::string toJson(const Manifest& manifest);
[[nodiscard]] Expected<Manifest> readManifest(std::string_view json, const std::string& file);

// The ids of the folder's own cells.
[[nodiscard]] std::vector<std::string> ownCells(const Manifest& manifest);

}  // namespace ssrkit
