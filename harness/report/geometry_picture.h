// oracle/geometry.png: what the rays truly meet, as colours over the picture.
#pragma once

#include "image/byte_image.h"
#include "oracle/geometry.h"

namespace ssrkit {

// Okabe and Ito's palette; the colours are listed in docs/techniques.md.
[[nodiscard]] Rgb8 colourOf(TrueClass true_class);

// `lit` (linear, RGB) where no ray starts, the class's colour elsewhere. Of one size (checked).
[[nodiscard]] ByteImage geometryPicture(const GeometryResult& geometry, const Image& lit);

}  // namespace ssrkit
