// EXR files: 32-bit float, origin upper left, channels by name.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/size.h"
#include "image/image.h"

namespace ssrkit {

// Written into the file's header as strings named "ssrkit:KEY".
using ExrMetadata = std::map<std::string, std::string>;

// Writes every channel as 32-bit float, losslessly, whole or not at all. The same image gives the same bytes.
// May be called from several threads at once.
[[nodiscard]] Expected<void> writeExr(const std::filesystem::path& path, const Image& image,
                                      const ExrMetadata& metadata = {});

// What a file must hold. Channels beyond these are ignored, whatever their order in the file.
struct ExrExpectation {
  std::vector<std::string> channels;  // the image has them in this order; empty: all that the file holds
  std::optional<Size> size;
};

// Reads half and float channels, scan lines or tiles (the finest level). NaN and infinity come through as
// they are. Refused, with the reason: anything that is no EXR, several parts, deep data, integer or
// subsampled channels, a crop or overscan, sides over 16,384 texels, more than 2 GiB of floats, damaged
// files.
[[nodiscard]] Expected<Image> readExr(const std::filesystem::path& path, const ExrExpectation& expected = {});

}  // namespace ssrkit
