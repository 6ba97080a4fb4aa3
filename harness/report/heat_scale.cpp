#include "report/heat_scale.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "image/colour_map.h"

namespace ssrkit {

namespace {

// 1, 2, 5, 10, 20, ... up to `limit` and the first beyond it.
std::vector<double> roundCountsPast(double limit) {
  std::vector<double> counts;
  for (double power = 1.0;; power *= 10.0) {
    for (const double leading : {1.0, 2.0, 5.0}) {
      counts.push_back(leading * power);
      if (counts.back() >= limit) {
        return counts;
      }
    }
  }
}

}  // namespace

HeatScale::HeatScale(std::span<const RayRecord* const> records) {
  std::uint32_t smallest = 0;
  std::uint32_t largest = 0;
  for (const RayRecord* record : records) {
    for (const RayHit& ray : record->rays) {
      if (ray.lookups > 0) {
        smallest = smallest == 0 ? ray.lookups : std::min(smallest, ray.lookups);
        largest = std::max(largest, ray.lookups);
      }
    }
  }
  if (largest == 0) {
    return;
  }
  const std::vector<double> counts = roundCountsPast(largest);
  high_ = std::max(counts.back(), 2.0);
  low_ = *std::find_if(counts.rbegin(), counts.rend(),
                       [&](double count) { return count <= smallest && count < high_; });
}

double HeatScale::placeOf(double count) const {
  if (count <= low_) {
    return 0.0;
  }
  return std::min(1.0, std::log(count / low_) / std::log(high_ / low_));
}

Rgb8 HeatScale::colourOf(double count) const {
  return sequentialColour(placeOf(count));
}

std::vector<double> HeatScale::ticks() const {
  std::vector<double> counts = roundCountsPast(high_);
  std::erase_if(counts, [&](double count) { return count < low_; });
  return counts;
}

}  // namespace ssrkit
