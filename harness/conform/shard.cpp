#include "conform/shard.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>

#include "base/hash128.h"
#include "base/text.h"

namespace ssrkit {

namespace {

constexpr int kMostShards = 100000;

bool parseWhole(std::string_view text, int& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

}  // namespace

Expected<Shard> parseShard(std::string_view text) {
  const std::vector<std::string> parts = split(text, '/');
  Shard shard;
  const bool is_read =
      parts.size() == 2 && parseWhole(parts[0], shard.index) && parseWhole(parts[1], shard.count);
  if (!is_read || shard.count < 1 || shard.count > kMostShards || shard.index < 1 ||
      shard.index > shard.count) {
    return inputError("read the shard", fmt::format("'{}' is no part of a whole", text), "--shard",
                      "write the second of three shards as 2/3");
  }
  return shard;
}

std::string shardText(const Shard& shard) {
  return fmt::format("{}/{}", shard.index, shard.count);
}

int shardOf(const Cell& cell, int count) {
  // The second of the name's two hashes: its low bits depend on every byte.
  const std::string digits = hashName(groupId(cell)).substr(16);
  std::uint64_t number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number, 16);
  return static_cast<int>(number % static_cast<std::uint64_t>(count)) + 1;
}

}  // namespace ssrkit
