#pragma once

#include <span>
#include <vector>

namespace ssrkit {

// The smallest of `values` that at least `percentile` percent of them do not exceed; 100: the largest.
// Infinities count as large; there must be no NaN, and `values` must not be empty (checked).
[[nodiscard]] double percentileOf(std::vector<double> values, double percentile);

// The same without a copy: the values are put in another order.
[[nodiscard]] double percentileAmong(std::span<double> values, double percentile);

}  // namespace ssrkit
