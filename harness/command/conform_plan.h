// What a `conform` was asked for: tests, scenes, devices, cells.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/error.h"
#include "check/expectation.h"
#include "command/conform.h"
#include "command/kit_paths.h"
#include "command/suite.h"
#include "conform/cell.h"
#include "conform/shard.h"

namespace ssrkit {

struct ConformPlan {
  std::vector<TestFile> tests;
  std::map<std::string, SceneSource> sources;  // by the scene's name in a cell
  std::vector<std::string> required;           // devices
  std::vector<std::string> optional;
  std::vector<Cell> cells;  // of all shards, in order
  std::vector<Cell> own;    // of this one
  Shard shard;

  [[nodiscard]] const TestFile& test(const Cell& cell) const;
  [[nodiscard]] const SceneSource& source(const Cell& cell) const { return sources.at(cell.scene); }
};

// Starts nothing.
[[nodiscard]] Expected<ConformPlan> makePlan(const ConformOptions& options, const KitPaths& paths);

// The devices that the test holds `device` against: the one that renders its input, and those of the truths
// that it asks of it.
[[nodiscard]] std::vector<std::string> referencesOf(const TestFile& test, const std::string& device);

// Every device that the plan's own cells are drawn on or held against.
[[nodiscard]] std::vector<std::string> devicesOf(const ConformPlan& plan);

}  // namespace ssrkit
