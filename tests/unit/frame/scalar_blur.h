// The gloss blur in scalar code and double precision, along one axis.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/glm.hpp>

#include "blur_image.h"
#include "pass_test.h"

namespace ssrkit {

// What a blur is given: a function of the texel for each image.
struct BlurredSurface {
  std::function<std::array<double, 4>(int x, int y)> source;
  std::function<double(int x, int y)> dist_view = [](int, int) { return kBlurDist; };
  std::function<double(int x, int y)> radius_px = [](int, int) { return 6.0; };
  std::function<std::array<double, 4>(int x, int y)> normal = [](int, int) {
    return std::array{0.0, 0.0, 1.0, 1.0};
  };
};

// Position in view space, the image's middle on the axis.
inline glm::dvec3 positionView(const BlurredSurface& surface, int x, int y) {
  const double dist = surface.dist_view(x, y);
  return {dist * (x + 0.5 - kBlurSize.width / 2.0) / kBlurPxScale,
          -dist * (y + 0.5 - kBlurSize.height / 2.0) / kBlurPxScale, -dist};
}

// Weight of one texel in another's blur along one axis, `offset` texels away.
inline double blurWeight(const BlurredSurface& surface, int x, int y, int other_x, int other_y, int offset) {
  const double radius = std::min(surface.radius_px(x, y), surface.radius_px(other_x, other_y));
  if (radius <= 0.0) {
    return 0.0;
  }
  const auto own = surface.normal(x, y);
  const auto other = surface.normal(other_x, other_y);
  const glm::dvec3 normal(own[0], own[1], own[2]);
  const double off_plane =
      std::abs(glm::dot(normal, positionView(surface, other_x, other_y) - positionView(surface, x, y)));
  const double plane = std::max(1.0 - off_plane / (0.01 * surface.dist_view(x, y)), 0.0);
  const double turned =
      std::max((glm::dot(normal, glm::dvec3(other[0], other[1], other[2])) - 0.9) / 0.1, 0.0);
  const double share = offset / radius;
  return std::pow(std::max(1.0 - share * share, 0.0), 2) * plane * turned;
}

// One axis in double precision: every tap within the radius, weighed, colours times alpha.
inline Image blurredAlong(const BlurredSurface& surface, const Image& source, bool along_y) {
  return imageOf(kBlurSize, [&](int x, int y) {
    const double radius = surface.radius_px(x, y);
    std::array<double, 4> sum{};
    double weights = 0.0;
    const int spacing = std::max(static_cast<int>(std::ceil(radius / 12.0)), 1);
    for (int tap = -12; tap <= 12; ++tap) {
      const int offset = tap * spacing;
      const int other_x = along_y ? x : x + offset;
      const int other_y = along_y ? y + offset : y;
      if (other_x < 0 || other_y < 0 || other_x >= kBlurSize.width || other_y >= kBlurSize.height) {
        continue;
      }
      const double weight = tap == 0 ? 1.0 : blurWeight(surface, x, y, other_x, other_y, offset);
      weights += weight;
      for (std::size_t channel = 0; channel < 4; ++channel) {
        const auto alpha = static_cast<double>(source.at(other_x, other_y, 3));
        sum[channel] +=
            weight *
            (channel < 3 ? alpha * static_cast<double>(source.at(other_x, other_y, channel)) : alpha);
      }
    }
    const double alpha = std::max(sum[3], 1e-30);
    return radius <= 1.0 ? std::array<double, 4>{source.at(x, y, 0), source.at(x, y, 1), source.at(x, y, 2),
                                                 source.at(x, y, 3)}
                         : std::array{sum[0] / alpha, sum[1] / alpha, sum[2] / alpha, sum[3] / weights};
  });
}

}  // namespace ssrkit
