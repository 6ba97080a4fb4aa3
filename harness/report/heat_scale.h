// The logarithmic colour scale of lookup counts, shared by all stages of a sheet.
#pragma once

#include <span>
#include <vector>

#include "image/byte_image.h"
#include "image/ray_record.h"

namespace ssrkit {

class HeatScale {
 public:
  // From the smallest to the largest count over 0 of all records, rounded outwards to 1, 2 or 5 times a power
  // of ten. 1 to 10 when no ray looked anything up.
  explicit HeatScale(std::span<const RayRecord* const> records);

  [[nodiscard]] double low() const { return low_; }
  [[nodiscard]] double high() const { return high_; }

  // 0 at `low` and below, 1 at `high` and above.
  [[nodiscard]] double placeOf(double count) const;
  [[nodiscard]] Rgb8 colourOf(double count) const;

  // The round counts from low to high.
  [[nodiscard]] std::vector<double> ticks() const;

 private:
  double low_ = 1.0;
  double high_ = 10.0;
};

}  // namespace ssrkit
