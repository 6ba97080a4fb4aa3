#include "oracle/watch.h"

#include <cmath>

namespace ssrkit {

namespace {

// Whether the coordinate `axis` comes within kTiePx of a texel's edge anywhere on the ray.
bool comesNearEdge(const ImageRay& ray, int axis) {
  const double from = ray.px_origin[axis];
  const double to = from + ray.sigma_end * ray.px_per_sigma[axis];
  return std::floor(std::min(from, to) - kTiePx) != std::floor(std::max(from, to) + kTiePx);
}

bool isOnEdge(double px) {
  return std::abs(px - std::round(px)) <= kTiePx;
}

}  // namespace

Watch::Watch(const ImageRay& ray) : near_limit_(1.0 + kTieRelative), far_limit_(1.0 - kTieRelative) {
  const int minor = minorAxis(ray);
  const double sigma_per_minor = std::abs(ray.sigma_per_px[minor]);
  const double sigma_per_major = std::abs(ray.sigma_per_px[1 - minor]);
  if (!std::isfinite(sigma_per_major)) {
    return;  // the ray stays on one point of the image
  }
  double sigma_margin = kTiePx * sigma_per_major;
  if (comesNearEdge(ray, minor)) {
    corner_sigma_ = kTiePx * (sigma_per_minor + sigma_per_major);
    // A footprint grown by kTiePx holds this much more of a ray that leaves it along the minor axis, but
    // never more than a whole texel along the major one.
    sigma_margin = std::min(kTiePx * sigma_per_minor, (1.0 + 2.0 * kTiePx) * sigma_per_major);
  }
  inv_dist_margin_ = std::abs(ray.inv_dist_per_sigma) * sigma_margin;
}

int minorAxis(const ImageRay& ray) {
  return std::abs(ray.px_per_sigma.x) < std::abs(ray.px_per_sigma.y) ? 0 : 1;
}

bool runsAlongEdge(const ImageRay& ray) {
  const int minor = minorAxis(ray);
  // Steeper rays leave the tolerance of an edge within half a texel, where only the corner's texel is near.
  const bool is_flat =
      std::abs(ray.px_per_sigma[minor]) < 2.0 * kTiePx * std::abs(ray.px_per_sigma[1 - minor]);
  return (is_flat && comesNearEdge(ray, minor)) || isOnEdge(ray.px_origin.x) || isOnEdge(ray.px_origin.y);
}

}  // namespace ssrkit
