#pragma once

#include <filesystem>

#include "base/error.h"

namespace ssrkit {

// Makes the folder and fails before any work is done when nothing could be written there afterwards.
[[nodiscard]] Expected<void> prepareFolder(const std::filesystem::path& folder);

}  // namespace ssrkit
