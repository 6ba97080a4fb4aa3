#include "base/entry_cache.h"

#include <fmt/format.h>

#include <cstdlib>

#include "base/atomic_file.h"
#include "base/hash128.h"

namespace ssrkit {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kEntryLimitBytes = std::size_t{64} << 20;

fs::path absoluteFolder(const char* variable) {
  const char* const value = std::getenv(variable);
  const fs::path path = value == nullptr ? "" : value;
  return path.is_absolute() ? path : fs::path();
}

}  // namespace

EntryCache EntryCache::ofUser(const std::string& kind, int version) {
  fs::path base = absoluteFolder("XDG_CACHE_HOME");
  if (base.empty()) {
    const fs::path home = absoluteFolder("HOME");
    base = home.empty() ? fs::path() : home / ".cache";
  }
  return {base.empty() ? fs::path() : base / "ssrkit" / kind, kind, version};
}

std::string EntryCache::firstLine(const std::string& recipe, const std::string& payload) const {
  return fmt::format("ssrkit-{} {} recipe {} payload {} {}\n", kind_, version_, recipe.size(), payload.size(),
                     hashName(payload));
}

fs::path EntryCache::pathOf(const std::string& recipe) const {
  return folder_ / fmt::format("{}.{}-entry", hashName(recipe), kind_);
}

std::optional<std::string> EntryCache::find(const std::string& recipe) const {
  if (folder_.empty()) {
    return std::nullopt;
  }
  const Expected<std::string> entry = readFile(pathOf(recipe), kEntryLimitBytes);
  if (!entry) {
    return std::nullopt;
  }
  const std::size_t line_end = entry->find('\n');
  if (line_end == std::string::npos || entry->compare(line_end + 1, recipe.size(), recipe) != 0) {
    return std::nullopt;
  }
  std::string payload = entry->substr(line_end + 1 + recipe.size());
  if (entry->compare(0, line_end + 1, firstLine(recipe, payload)) != 0) {
    return std::nullopt;
  }
  return payload;
}

void EntryCache::store(const std::string& recipe, const std::string& payload) const {
  if (!folder_.empty()) {
    static_cast<void>(writeFileAtomically(pathOf(recipe), firstLine(recipe, payload) + recipe + payload));
  }
}

}  // namespace ssrkit
