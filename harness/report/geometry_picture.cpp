#include "report/geometry_picture.h"

#include <algorithm>
#include <array>

#include "base/check.h"
#include "image/colour_map.h"

namespace ssrkit {

Rgb8 colourOf(TrueClass true_class) {
  static constexpr std::array<Rgb8, kTrueClassCount> kColours = {{{128, 128, 128},
                                                                  okabe_ito::kBluishGreen,
                                                                  okabe_ito::kYellow,
                                                                  okabe_ito::kVermillion,
                                                                  okabe_ito::kReddishPurple,
                                                                  okabe_ito::kBlue,
                                                                  okabe_ito::kSkyBlue}};
  return kColours.at(static_cast<std::size_t>(true_class));
}

ByteImage geometryPicture(const GeometryResult& geometry, const Image& lit) {
  SSRKIT_CHECK(geometry.size() == lit.size);
  ByteImage picture = toneMap(lit);
  for (int y = 0; y < lit.size.height; ++y) {
    for (int x = 0; x < lit.size.width; ++x) {
      const TrueClass true_class = geometry.at(x, y).true_class;
      if (true_class != TrueClass::kNone) {
        std::ranges::copy(colourOf(true_class),
                          picture.data.begin() + static_cast<std::ptrdiff_t>(picture.index(x, y)));
      }
    }
  }
  return picture;
}

}  // namespace ssrkit
