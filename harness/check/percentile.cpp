#include "check/percentile.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/check.h"

namespace ssrkit {

double percentileOf(std::vector<double> values, double percentile) {
  return percentileAmong(values, percentile);
}

double percentileAmong(std::span<double> values, double percentile) {
  SSRKIT_CHECK(!values.empty());
  const double count = static_cast<double>(values.size());
  const double rank = std::clamp(std::ceil(percentile / 100.0 * count), 1.0, count);
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(rank) - 1;
  std::ranges::nth_element(values, nth);
  return *nth;
}

}  // namespace ssrkit
