// Which cells a run is made of, and in which order.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "check/expectation.h"
#include "conform/cell.h"
#include "conform/shard.h"

namespace ssrkit {

struct MatrixAxes {
  std::vector<std::string> built_in_scenes;  // what a test's "all" stands for
  std::vector<std::string> scenes;           // the scenes to keep; empty: those of each test
  std::vector<std::string> devices;          // of the run; a test may name a part of them
  Size size;                                 // of tests that name none
};

// Every cell of the tests: tests in their order, then scenes, sizes and devices.
[[nodiscard]] std::vector<Cell> matrix(std::span<const TestFile> tests, const MatrixAxes& axes);

struct Selection {
  std::vector<std::string> filters;   // globs (matchesCell); empty: all cells
  std::vector<std::string> excludes;  // likewise, what is left out
  std::optional<std::uint64_t> shuffle_seed;
};

// The selected cells. The cells of a group stay together; a seed gives one order of groups whatever else is
// selected. Fails on a glob that matches no cell, with the nearest id, and when no cell is left.
[[nodiscard]] Expected<std::vector<Cell>> select(std::span<const Cell> all, const Selection& selection);

// The cells of one shard, in the plan's order. It may have none.
[[nodiscard]] std::vector<Cell> cellsOfShard(std::span<const Cell> cells, const Shard& shard);

// Cells that follow each other and share their group.
[[nodiscard]] std::vector<std::vector<Cell>> groupsOf(std::span<const Cell> cells);

}  // namespace ssrkit
