#include "device/format.h"

#include <algorithm>

#include "base/check.h"
#include "device/device.h"

namespace ssrkit {
namespace {

struct FormatRow {
  Format format;
  const char* name;
  FormatInfo info;
};

constexpr std::array kFormatRows{
    FormatRow{Format::kR8ui, "kR8ui", {1, 1, true}},
    FormatRow{Format::kRgba8, "kRgba8", {4, 4, false}},
    FormatRow{Format::kRgba8Srgb, "kRgba8Srgb", {4, 4, false}},
    FormatRow{Format::kRg16i, "kRg16i", {2, 4, true}},
    FormatRow{Format::kRgba16ui, "kRgba16ui", {4, 8, true}},
    FormatRow{Format::kRgba16f, "kRgba16f", {4, 8, false}},
    FormatRow{Format::kR32f, "kR32f", {1, 4, false}},
    FormatRow{Format::kRg32f, "kRg32f", {2, 8, false}},
    FormatRow{Format::kRgba32f, "kRgba32f", {4, 16, false}},
    FormatRow{Format::kD32f, "kD32f", {1, 4, false}},
};

const FormatRow& rowOf(Format format) {
  const auto* const row = std::ranges::find(kFormatRows, format, &FormatRow::format);
  SSRKIT_CHECK(row != kFormatRows.end());
  return *row;
}

}  // namespace

FormatInfo formatInfo(Format format) {
  return rowOf(format).info;
}

const char* formatName(Format format) {
  return rowOf(format).name;
}

Size mipSize(const ImageDesc& desc, int mip) {
  SSRKIT_CHECK_LE(0, mip);
  SSRKIT_CHECK_LT(mip, desc.mip_count);
  return {std::max(1, desc.size.width >> mip), std::max(1, desc.size.height >> mip)};
}

std::size_t mipByteCount(const ImageDesc& desc, int mip) {
  const Size size = mipSize(desc, mip);
  return static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) *
         formatInfo(desc.format).bytes_per_texel;
}

}  // namespace ssrkit
