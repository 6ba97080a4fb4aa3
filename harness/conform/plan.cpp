#include "conform/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/hash128.h"
#include "base/text.h"

namespace ssrkit {

namespace {

bool isAmong(const std::vector<std::string>& names, const std::string& name_sought) {
  return std::ranges::find(names, name_sought) != names.end();
}

std::vector<std::string> scenesOf(const TestFile& test, const MatrixAxes& axes) {
  const bool all = test.scenes == std::vector<std::string>{"all"};
  if (all && !axes.scenes.empty()) {
    return axes.scenes;  // also files of the user's own
  }
  std::vector<std::string> scenes = all ? axes.built_in_scenes : test.scenes;
  std::erase_if(
      scenes, [&](const std::string& scene) { return !axes.scenes.empty() && !isAmong(axes.scenes, scene); });
  return scenes;
}

Expected<void> requireMatches(std::span<const Cell> all, const std::vector<std::string>& globs,
                              const std::string& option) {
  for (const std::string& glob : globs) {
    if (std::ranges::any_of(all, [&](const Cell& cell) { return matchesCell(glob, cellId(cell)); })) {
      continue;
    }
    std::vector<std::string> names;
    for (const Cell& cell : all) {
      names.push_back(cellId(cell));
      if (!isAmong(names, cell.test)) {
        names.push_back(cell.test);
      }
    }
    const auto nearest = nearestName(glob, names);
    return inputError(
        "select cells", fmt::format("no cell matches '{}'", glob), option,
        nearest ? fmt::format("did you mean '{}'?", *nearest) : "./ssrkit conform --list shows their ids");
  }
  return {};
}

bool matchesAny(const std::vector<std::string>& globs, const std::string& id) {
  return std::ranges::any_of(globs, [&](const std::string& glob) { return matchesCell(glob, id); });
}

// Each group's place follows from the seed and its id alone, so that a part of the plan keeps the whole's
// order.
void shuffle(std::vector<Cell>& cells, std::uint64_t seed) {
  std::vector<std::pair<std::string, Cell>> keyed;
  keyed.reserve(cells.size());
  for (Cell& cell : cells) {
    keyed.emplace_back(hashName(fmt::format("{} {}", seed, groupId(cell))), std::move(cell));
  }
  std::ranges::stable_sort(keyed, {}, &std::pair<std::string, Cell>::first);
  cells.clear();
  for (auto& [key, cell] : keyed) {
    cells.push_back(std::move(cell));
  }
}

}  // namespace

std::vector<Cell> matrix(std::span<const TestFile> tests, const MatrixAxes& axes) {
  std::vector<Cell> cells;
  for (const TestFile& test : tests) {
    const std::vector<Size> sizes = test.sizes.empty() ? std::vector{axes.size} : test.sizes;
    for (const std::string& scene : scenesOf(test, axes)) {
      for (const Size size : sizes) {
        for (const std::string& device : axes.devices) {
          if (test.devices.empty() || isAmong(test.devices, device)) {
            cells.push_back({test.id, scene, size, device});
          }
        }
      }
    }
  }
  return cells;
}

Expected<std::vector<Cell>> select(std::span<const Cell> all, const Selection& selection) {
  const auto known = requireMatches(all, selection.filters, "--filter").and_then([&] {
    return requireMatches(all, selection.excludes, "--exclude");
  });
  if (!known) {
    return tl::make_unexpected(known.error());
  }
  std::vector<Cell> cells;
  std::ranges::copy_if(all, std::back_inserter(cells), [&](const Cell& cell) {
    const std::string id = cellId(cell);
    return (selection.filters.empty() || matchesAny(selection.filters, id)) &&
           !matchesAny(selection.excludes, id);
  });
  if (cells.empty()) {
    return inputError("select cells", "no cell is left", "",
                      "loosen --scene, --device, --filter or --exclude; --list shows the cells' ids");
  }
  if (selection.shuffle_seed) {
    shuffle(cells, *selection.shuffle_seed);
  }
  return cells;
}

std::vector<Cell> cellsOfShard(std::span<const Cell> cells, const Shard& shard) {
  std::vector<Cell> part;
  std::ranges::copy_if(cells, std::back_inserter(part),
                       [&](const Cell& cell) { return shardOf(cell, shard.count) == shard.index; });
  return part;
}

std::vector<std::vector<Cell>> groupsOf(std::span<const Cell> cells) {
  std::vector<std::vector<Cell>> groups;
  for (const Cell& cell : cells) {
    if (groups.empty() || groupId(groups.back().front()) != groupId(cell)) {
      groups.emplace_back();
    }
    groups.back().push_back(cell);
  }
  return groups;
}

}  // namespace ssrkit
