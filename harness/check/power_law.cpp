#include "check/power_law.h"

#include <algorithm>
#include <cmath>

namespace ssrkit {

std::optional<PowerLaw> fitPowerLaw(std::span<const PowerLawPoint> points) {
  const auto is_positive = [](double value) { return value > 0.0 && std::isfinite(value); };
  const bool all_positive = std::ranges::all_of(
      points, [&](const PowerLawPoint& point) { return is_positive(point.x) && is_positive(point.y); });
  if (points.size() < 2 || !all_positive) {
    return std::nullopt;
  }
  const auto count = static_cast<double>(points.size());
  double mean_x = 0.0;
  double mean_y = 0.0;
  for (const PowerLawPoint& point : points) {
    mean_x += std::log(point.x) / count;
    mean_y += std::log(point.y) / count;
  }
  double sum_xx = 0.0;
  double sum_xy = 0.0;
  for (const PowerLawPoint& point : points) {
    const double dx = std::log(point.x) - mean_x;
    sum_xx += dx * dx;
    sum_xy += dx * (std::log(point.y) - mean_y);
  }
  constexpr double kLeastSpread = 1e-12;  // below it the x are one
  if (sum_xx < kLeastSpread) {
    return std::nullopt;
  }
  const double exponent = sum_xy / sum_xx;
  double squares = 0.0;
  for (const PowerLawPoint& point : points) {
    const double residual = std::log(point.y) - mean_y - exponent * (std::log(point.x) - mean_x);
    squares += residual * residual;
  }
  const double error = points.size() > 2 ? std::sqrt(squares / (count - 2.0) / sum_xx) : 0.0;
  return PowerLaw{exponent, error, std::exp(mean_y - exponent * mean_x)};
}

}  // namespace ssrkit
