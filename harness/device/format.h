// Sizes of mips, for every device alike.
#pragma once

#include <cstddef>

#include "base/size.h"
#include "device/device.h"

namespace ssrkit {

// max(1, size >> mip); the mip must exist.
[[nodiscard]] Size mipSize(const ImageDesc& desc, int mip);

// Bytes of the mip's tightly packed rows.
[[nodiscard]] std::size_t mipByteCount(const ImageDesc& desc, int mip);

// "kRgba32f"
[[nodiscard]] const char* formatName(Format format);

}  // namespace ssrkit
