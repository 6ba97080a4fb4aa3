// Colours of pictures for people, chosen to be told apart with any colour vision.
#pragma once

#include "image/byte_image.h"
#include "image/image.h"
#include "image/ray_record.h"

namespace ssrkit {

// The eight categorical colours of Okabe and Ito, "Color Universal Design" (2008), as sRGB bytes.
namespace okabe_ito {
inline constexpr Rgb8 kBlack = {0, 0, 0};
inline constexpr Rgb8 kOrange = {230, 159, 0};
inline constexpr Rgb8 kSkyBlue = {86, 180, 233};
inline constexpr Rgb8 kBluishGreen = {0, 158, 115};
inline constexpr Rgb8 kYellow = {240, 228, 66};
inline constexpr Rgb8 kBlue = {0, 114, 178};
inline constexpr Rgb8 kVermillion = {213, 94, 0};
inline constexpr Rgb8 kReddishPurple = {204, 121, 167};
}  // namespace okabe_ito

[[nodiscard]] Rgb8 colourOf(RayClass ray_class);

// Viridis: dark purple at 0, yellow at 1, lightness rising evenly. `t` is clamped; NaN gives 0's colour.
[[nodiscard]] Rgb8 sequentialColour(double t);

// IEC 61966-2-1: linear 0..1 to encoded 0..1. Not clamped.
[[nodiscard]] double srgbEncode(double linear);

// `from` to `to` by `weight` 0..1, on encoded values.
[[nodiscard]] Rgb8 blend(Rgb8 from, Rgb8 to, double weight);

// Preview of linear light: multiplied by `exposure`, clamped to 0..1, encoded. Takes the image's first three
// channels, or its only one as grey; NaN becomes magenta so that it cannot be missed.
[[nodiscard]] ByteImage toneMap(const Image& linear, double exposure = 1.0);

}  // namespace ssrkit
