// Files appear under their final name whole or not at all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "base/error.h"

namespace ssrkit {

// Writes `content` to a temporary name beside `path`, flushes it to the disk's cache and renames it.
// Creates missing parent folders. On any failure the temporary file is removed and `path` is untouched.
[[nodiscard]] Expected<void> writeFileAtomically(const std::filesystem::path& path, std::string_view content);

// The same for a writer that needs a file name of its own (OpenImageIO): `write(temporary)` fills the file.
// The temporary name keeps `path`'s extension.
[[nodiscard]] Expected<void> writeFileAtomically(
    const std::filesystem::path& path,
    const std::function<Expected<void>(const std::filesystem::path&)>& write);

// Removes the temporary files of writes that are under way. Only calls that are safe in a signal handler.
void removeUnfinishedFiles() noexcept;

// The whole file. Fails on a missing file, a folder, and a file over `size_limit_bytes`.
[[nodiscard]] Expected<std::string> readFile(const std::filesystem::path& path,
                                             std::size_t size_limit_bytes = std::size_t{256} << 20);

}  // namespace ssrkit
