// What takes long to make, on disk, named by what it was made from. Several runs may share the folder: an
// entry appears whole or not at all, and a damaged one counts as absent.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

namespace ssrkit {

class EntryCache {
 public:
  // $XDG_CACHE_HOME/ssrkit/KIND, or ~/.cache/ssrkit/KIND; no folder at all when neither is set. Raise
  // `version` when the same recipe gives another payload or the bytes of a payload mean something else.
  [[nodiscard]] static EntryCache ofUser(const std::string& kind, int version);

  EntryCache() = default;  // keeps nothing
  EntryCache(std::filesystem::path folder, std::string kind, int version)
      : folder_(std::move(folder)), kind_(std::move(kind)), version_(version) {}

  // `recipe` is everything that decides the payload; the entry holds it and is refused when it differs.
  [[nodiscard]] std::optional<std::string> find(const std::string& recipe) const;

  // Does nothing when the folder cannot be written: the next run makes it again.
  void store(const std::string& recipe, const std::string& payload) const;

  [[nodiscard]] std::filesystem::path pathOf(const std::string& recipe) const;

 private:
  [[nodiscard]] std::string firstLine(const std::string& recipe, const std::string& payload) const;

  std::filesystem::path folder_;
  std::string kind_;
  int version_ = 0;
};

}  // namespace ssrkit
