#include "check/march_samples.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ssrkit {

namespace {

glm::ivec2 texelAt(glm::dvec2 px) {
  return {static_cast<int>(std::floor(px.x)), static_cast<int>(std::floor(px.y))};
}

// Samples before the bisections, which only hits have and only marches that can step over texels.
std::size_t sampleCount(MarchSpacing spacing, const TraceParameters& parameters, const RayHit& hit) {
  const bool refines = spacing == MarchSpacing::kMetres || parameters.stride_px > 1;
  const bool is_hit = hit.ray_class == RayClass::kHit;
  const int bisections = is_hit && refines ? std::max(parameters.bisection_count, 0) : 0;
  return hit.steps - std::min(hit.steps, static_cast<std::uint32_t>(bisections));
}

}  // namespace

// From t_m = sigma * dist_view, and 1 / dist_view linear in sigma.
double sigmaAtMetres(const ImageRay& ray, double t_m) {
  return t_m * ray.inv_dist_origin / (1.0 - t_m * ray.inv_dist_per_sigma);
}

double lengthMetres(const ImageRay& ray) {
  constexpr double kVanishingMarginPx = 0.5;
  const double speed_px = std::max(std::abs(ray.px_per_sigma.x), std::abs(ray.px_per_sigma.y));
  const double margin = kVanishingMarginPx / speed_px * std::abs(ray.inv_dist_per_sigma);
  return ray.sigma_end / std::max(ray.invDistAt(ray.sigma_end), std::min(margin, ray.inv_dist_origin));
}

std::optional<MarchSpacing> marchSpacing(std::string_view stage) {
  if (stage == "naive" || stage == "refined") {
    return MarchSpacing::kMetres;
  }
  if (stage == "dda") {
    return MarchSpacing::kColumns;
  }
  return std::nullopt;
}

std::vector<glm::ivec2> marchSamples(MarchSpacing spacing, const ImageRay& ray,
                                     const TraceParameters& parameters, const RayHit& hit) {
  const std::size_t count = sampleCount(spacing, parameters, hit);
  std::vector<glm::ivec2> texels;
  texels.reserve(count);
  const double length_m = lengthMetres(ray);
  const double step_m = parameters.step_m > 0.0 ? std::max(parameters.step_m, length_m / kMaxStepCount)
                                                : length_m / parameters.step_count;
  const int axis = std::abs(ray.px_per_sigma.x) >= std::abs(ray.px_per_sigma.y) ? 0 : 1;
  const double direction = ray.px_per_sigma[axis] >= 0.0 ? 1.0 : -1.0;
  const double near_edge = std::floor(ray.px_origin[axis]) + (direction > 0.0 ? 1.0 : 0.0);
  for (std::size_t i = 1; i <= count; ++i) {
    double sigma = 0.0;
    if (spacing == MarchSpacing::kMetres) {
      sigma = sigmaAtMetres(ray, std::min(static_cast<double>(i) * step_m, length_m));
    } else {
      // Stride 1 looks in the middle of every column; longer strides count from the ray's origin.
      const double px = parameters.stride_px > 1
                            ? ray.px_origin[axis] + direction * parameters.stride_px * static_cast<double>(i)
                            : near_edge + direction * (static_cast<double>(i) - 0.5);
      sigma = std::clamp(ray.sigmaAt(axis, px), 0.0, ray.sigma_end);
    }
    texels.push_back(texelAt(ray.pxAt(sigma)));
  }
  return texels;
}

}  // namespace ssrkit
