// One of n parts of a plan, for machines that share the work.
#pragma once

#include <string>
#include <string_view>

#include "base/error.h"
#include "conform/cell.h"

namespace ssrkit {

struct Shard {
  int index = 1;  // 1 to count
  int count = 1;

  bool operator==(const Shard&) const = default;
};

// "2/3"
[[nodiscard]] Expected<Shard> parseShard(std::string_view text);
[[nodiscard]] std::string shardText(const Shard& shard);

// Which shard (from 1) of `count` a cell belongs to: by a hash of its group's id, so that cells that are held
// against each other share a shard, and a new test moves no other cell.
[[nodiscard]] int shardOf(const Cell& cell, int count);

}  // namespace ssrkit
