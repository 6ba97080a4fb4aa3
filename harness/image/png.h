#pragma once

#include <filesystem>

#include "base/error.h"
#include "image/byte_image.h"

namespace ssrkit {

// Writes 8-bit RGB or RGBA, whole or not at all.
[[nodiscard]] Expected<void> writePng(const std::filesystem::path& path, const ByteImage& image);

// Reads 8- or 16-bit PNG as 8-bit RGB or RGBA; grey becomes RGB. Refused: damaged files, sides over 16,384
// texels.
[[nodiscard]] Expected<ByteImage> readPng(const std::filesystem::path& path);

}  // namespace ssrkit
