#include "check/march_step.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "check/march_samples.h"

namespace ssrkit {

namespace {

constexpr std::array<std::pair<std::string_view, StepKind>, 8> kKinds = {{
    {"naive", StepKind::kPoints},
    {"refined", StepKind::kMetres},
    {"world", StepKind::kPoints},
    {"exponential", StepKind::kExponential},
    {"adaptive", StepKind::kAdaptive},
    {"dda", StepKind::kPixels},
    {"homogeneous", StepKind::kPixels},
    {"capped", StepKind::kCapped},
}};

bool isInPixels(StepKind kind) {
  return kind == StepKind::kPixels || kind == StepKind::kCapped;
}

double longerSpeedPx(const ImageRay& ray) {
  return std::max(std::abs(ray.px_per_sigma.x), std::abs(ray.px_per_sigma.y));
}

// Of the step in metres that ends at t_m, at most.
double stepMetres(StepKind kind, const ImageRay& ray, const TraceParameters& parameters, double t_m) {
  const double count = std::max(parameters.step_count, 1);
  const double growth = std::max(parameters.step_growth, 1.0);
  const bool grows = (kind == StepKind::kExponential || kind == StepKind::kAdaptive) && growth > 1.0;
  double base_m = parameters.step_m > 0.0 ? parameters.step_m : lengthMetres(ray) / count;
  if (kind == StepKind::kExponential && grows && parameters.step_m <= 0.0) {
    base_m *= count * (growth - 1.0) / std::expm1(count * std::log(growth));
  }
  // Steps of b, b g, b g^2, ... have come t = b (g^k - 1) / (g - 1) far when the next is b g^k = b + (g - 1)
  // t.
  return grows ? base_m + (growth - 1.0) * t_m : base_m;
}

double stepPixels(StepKind kind, const ImageRay& ray, const TraceParameters& parameters) {
  const double stride_px = std::max(parameters.stride_px, 1);
  const double spread_px = ray.sigma_end * longerSpeedPx(ray) / std::max(parameters.step_count, 1);
  return kind == StepKind::kCapped ? std::max(stride_px, spread_px) : stride_px;
}

}  // namespace

std::optional<StepKind> stepKind(std::string_view stage) {
  const std::string_view family = stage.substr(0, stage.find('_'));
  const auto* const found = std::ranges::find(kKinds, family, &std::pair<std::string_view, StepKind>::first);
  return found == kKinds.end() ? std::nullopt : std::optional(found->second);
}

double stepStart(StepKind kind, const ImageRay& ray, const TraceParameters& parameters, double sigma) {
  if (isInPixels(kind)) {
    return std::max(0.0, sigma - stepPixels(kind, ray, parameters) / longerSpeedPx(ray));
  }
  const double t_m = ray.tMetresAt(sigma);
  return sigmaAtMetres(ray, std::max(0.0, t_m - stepMetres(kind, ray, parameters, t_m)));
}

double stepEnd(StepKind kind, const ImageRay& ray, const TraceParameters& parameters, double sigma) {
  if (isInPixels(kind)) {
    return sigma + stepPixels(kind, ray, parameters) / longerSpeedPx(ray);
  }
  const double t_m = ray.tMetresAt(sigma);
  const double end_m = t_m + stepMetres(kind, ray, parameters, t_m);
  // Beyond the vanishing point no length in metres is.
  return end_m < lengthMetres(ray) ? sigmaAtMetres(ray, end_m) : std::numeric_limits<double>::infinity();
}

double marchEnd(StepKind kind, const ImageRay& ray) {
  const double margin = 0.5 / longerSpeedPx(ray);
  const bool vanishes = ray.invDistAt(ray.sigma_end) < margin * std::abs(ray.inv_dist_per_sigma);
  if (isInPixels(kind)) {
    return vanishes ? std::max(0.0, ray.sigma_end - margin) : ray.sigma_end;
  }
  return std::min(ray.sigma_end, sigmaAtMetres(ray, lengthMetres(ray)));
}

}  // namespace ssrkit
