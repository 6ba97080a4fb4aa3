#include "check/geometry_image.h"

#include <algorithm>
#include <array>

#include "base/check.h"

namespace ssrkit {

Image toImage(const GeometryResult& geometry, std::span<const GeometryVerdict> verdicts) {
  SSRKIT_CHECK_EQ(geometry.pixelCount(), verdicts.size());
  Image image(geometry.size(), {"class", "px.x", "px.y", "t_m", "dist_view", "verdict"});
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    const TrueRay& ray = geometry.at(i);
    const glm::dvec2 px = ray.dist_view > 0.0 ? ray.plane.px : glm::dvec2(-1.0);
    const std::array<float, 6> values = {static_cast<float>(ray.true_class), static_cast<float>(px.x),
                                         static_cast<float>(px.y),           static_cast<float>(ray.t_m),
                                         static_cast<float>(ray.dist_view),  static_cast<float>(verdicts[i])};
    std::ranges::copy(values, image.data.begin() + static_cast<std::ptrdiff_t>(values.size() * i));
  }
  return image;
}

}  // namespace ssrkit
