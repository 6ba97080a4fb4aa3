// The command `conform`: the conformance matrix.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "command/limit_options.h"
#include "conform/extra_tests.h"

namespace ssrkit {

struct ConformOptions {
  std::vector<std::string> devices;           // must be there; empty: every software device
  std::vector<std::string> optional_devices;  // skipped where they are not there
  std::vector<std::string> scenes;            // empty: those of each test
  std::vector<std::string> filters;
  std::vector<std::string> excludes;
  std::optional<std::uint64_t> shuffle_seed;
  std::string shard = "1/1";
  std::filesystem::path rerun_failed;  // a folder of an earlier run; empty: every cell
  std::filesystem::path out = "out/conform";
  std::filesystem::path baseline;  // known failures; empty: the kit's own list
  ExtraPasses extra;               // cells beside those of the tests
  LimitOptions limits;
  int repeat = 1;
  int jobs = 0;  // groups of cells that run at once; 0: as many as processors, at most 4
  bool resume = false;
  bool list = false;
  bool json = false;
  std::vector<std::string> command;  // argv, for results.json
};

[[nodiscard]] Expected<int> conformCommand(const ConformOptions& options);

struct ConformMergeOptions {
  std::vector<std::string> folders;
  std::filesystem::path out = "out/conform";
  std::filesystem::path baseline;
  bool json = false;
  std::vector<std::string> command;
};

// `conform merge`: the folders of shards become one.
[[nodiscard]] Expected<int> conformMergeCommand(const ConformMergeOptions& options);

}  // namespace ssrkit
