// How a cost grows with what drives it: cost = factor * x ^ exponent.
#pragma once

#include <optional>
#include <span>

namespace ssrkit {

struct PowerLawPoint {
  double x = 0.0;
  double y = 0.0;
};

struct PowerLaw {
  double exponent = 0.0;
  double standard_error = 0.0;  // of the exponent; 0 where there are two points, which any line meets
  double factor = 1.0;          // y at x = 1
};

// Least squares through the logarithms. None with fewer than two different x, or where an x or y is not
// positive and finite.
[[nodiscard]] std::optional<PowerLaw> fitPowerLaw(std::span<const PowerLawPoint> points);

}  // namespace ssrkit
