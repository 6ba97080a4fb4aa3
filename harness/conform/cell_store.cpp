#include "conform/cell_store.h"

#include <system_error>

#include "base/atomic_file.h"

namespace ssrkit {

namespace fs = std::filesystem;

fs::path CellStore::fileOf(const std::string& id) const {
  return folder_ / "cells" / (id + ".json");
}

fs::path CellStore::pictureOf(const std::string& id, const std::string& picture) const {
  return folder_ / "cells" / (id + "." + picture + ".png");
}

Expected<void> CellStore::write(const Manifest& manifest) const {
  return writeFileAtomically(folder_ / "plan.json", toJson(manifest));
}

Expected<void> CellStore::write(const CellRecord& record) const {
  return writeFileAtomically(fileOf(record.id), toJson(record));
}

Expected<void> CellStore::remove(const std::string& id) const {
  std::error_code failure;
  fs::remove(fileOf(id), failure);
  const fs::path parent = fileOf(id).parent_path();
  const std::string prefix = fs::path(id).filename().string() + ".";
  std::error_code no_folder;  // of a cell that never ran
  for (const auto& entry : fs::directory_iterator(parent, no_folder)) {
    const std::string file = entry.path().filename().string();
    if (!failure && file.starts_with(prefix) && file.ends_with(".png")) {
      fs::remove(entry.path(), failure);
    }
  }
  if (failure) {
    return setupError("clear the earlier result of a cell", failure.message(), fileOf(id).string(),
                      "choose another folder with --out");
  }
  return {};
}

Expected<Manifest> CellStore::manifest() const {
  const fs::path file = folder_ / "plan.json";
  const auto content = readFile(file);
  return content ? readManifest(*content, file.string()) : tl::make_unexpected(content.error());
}

Expected<std::optional<CellRecord>> CellStore::find(const std::string& id) const {
  const fs::path file = fileOf(id);
  std::error_code unreadable;
  if (!fs::exists(file, unreadable)) {
    return std::nullopt;
  }
  const auto content = readFile(file);
  if (!content) {
    return tl::make_unexpected(content.error());
  }
  auto record = readCellRecord(*content, file.string());
  if (!record) {
    return tl::make_unexpected(record.error());
  }
  if (record->id != id) {
    return inputError("read a result of an earlier run", "it is the result of " + record->id, file.string(),
                      "run that cell again");
  }
  return std::optional(std::move(*record));
}

std::optional<CellRecord> CellStore::finished(const std::string& id, const std::string& inputs) const {
  auto record = find(id);
  if (!record || !*record || (*record)->inputs != inputs) {
    return std::nullopt;
  }
  return std::move(*record);
}

}  // namespace ssrkit
