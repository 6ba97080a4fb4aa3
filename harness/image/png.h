#pragma once

#include <filesystem>

#include "base/error.h"
#include "image/byte_image.h"

namespace ssrkit {

// Writes 8-bit RGB or RGBA, whole or not at all.
[[nodiscard]] Expected<void> writePng(const std::filesystem::path& path, const ByteImage& image);

}  // namespace ssrkit
