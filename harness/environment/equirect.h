// An environment from a file: an equirectangular EXR, twice as wide as high.
//
// Row 0 is the zenith (+y in world space), the middle column looks along -z, and columns run to the right as
// seen from inside, so +x stands at three quarters of the width.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <string>

#include "base/error.h"
#include "image/image.h"

namespace ssrkit {

inline constexpr int kMaxEquirectWidth = 8192;  // texels
inline constexpr std::size_t kMaxEquirectBytes = std::size_t{1} << 30;

// Refused, each in a sentence: what is no EXR or lacks R, G and B; another shape than 2:1 and more than
// kMaxEquirectWidth texels a row, both before the texels are decoded; texels that are not finite, negative,
// or over 65504, the largest radiance that the frame's half-precision images hold.
[[nodiscard]] Expected<Image> readEquirect(const std::filesystem::path& file);

// Position on the image, in texels from its upper left corner, of a unit direction in world space.
[[nodiscard]] glm::vec2 equirectFromDirection(glm::vec3 direction, Size size);

// Bilinear, around the seam; the poles' rows are not mixed across the pole.
[[nodiscard]] glm::vec3 sampleEquirect(const Image& image, glm::vec3 direction);

}  // namespace ssrkit
