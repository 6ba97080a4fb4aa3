// The parts of an EXR header that decide whether the kit reads the file at all. OpenEXR allocates by the
// sizes that a header claims, so these are looked at first, from the format's description (openexr.com,
// "OpenEXR File Layout").
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/size.h"

namespace ssrkit {

struct ExrHeader {
  Size size;
  std::vector<std::string> channels;  // in the file's order: alphabetical
  std::vector<std::string> integer_channels;
  bool has_subsampled_channel = false;
  bool is_crop = false;  // the data window is not the display window
};

// Reads the header of a single-part, flat file. On failure returns false and says why in `problem`.
[[nodiscard]] bool readExrHeader(std::string_view file, ExrHeader& header, std::string& problem);

}  // namespace ssrkit
