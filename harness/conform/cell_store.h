// A folder of results: plan.json, and one file a cell, cells/ID.json. A file appears whole or not at all, so
// a run that ends at any moment leaves what it finished.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/error.h"
#include "conform/cell_record.h"
#include "conform/manifest.h"

namespace ssrkit {

class CellStore {
 public:
  explicit CellStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

  // Fails where the folder cannot be written: a setup error, with what was finished still in place.
  [[nodiscard]] Expected<void> write(const Manifest& manifest) const;
  [[nodiscard]] Expected<void> write(const CellRecord& record) const;

  // Takes away what an earlier run left of a cell: its record and its pictures.
  [[nodiscard]] Expected<void> remove(const std::string& id) const;

  [[nodiscard]] Expected<Manifest> manifest() const;

  // None where the cell was never finished. A file that is damaged is an error.
  [[nodiscard]] Expected<std::optional<CellRecord>> find(const std::string& id) const;

  // A finished record of the same inputs; a damaged one counts as none, and the cell is run again.
  [[nodiscard]] std::optional<CellRecord> finished(const std::string& id, const std::string& inputs) const;

  [[nodiscard]] std::filesystem::path fileOf(const std::string& id) const;
  // Where pictures of a failed cell go: beside its record.
  [[nodiscard]] std::filesystem::path pictureOf(const std::string& id, const std::string& picture) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace ssrkit
