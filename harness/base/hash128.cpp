#include "base/hash128.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "base/text.h"

namespace ssrkit {

namespace {

// Eight bytes at a time: multiply, fold the high half down, so that every bit of a word moves every later
// one.
std::uint64_t foldWords(std::string_view bytes) {
  constexpr std::uint64_t kOddA = 0x9E3779B97F4A7C15ULL;  // 2^64 over the golden ratio
  constexpr std::uint64_t kOddB = 0xD6E8FEB86659FD93ULL;
  std::uint64_t hash = kOddA ^ (bytes.size() * kOddB);
  for (std::size_t at = 0; at < bytes.size(); at += sizeof(std::uint64_t)) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + at, std::min(sizeof word, bytes.size() - at));
    hash = (hash ^ word) * kOddA;
    hash = (hash ^ (hash >> 29)) * kOddB;
    hash ^= hash >> 32;
  }
  return hash;
}

}  // namespace

std::string hashName(std::string_view bytes) {
  return fmt::format("{:016x}{:016x}", hashBytes(bytes), foldWords(bytes));
}

}  // namespace ssrkit
