// A made-up trace that looks like one: sky above, a wall, and a mirror floor that reflects the wall.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "check/verdict.h"
#include "image/image.h"
#include "image/ray_record.h"

namespace ssrkit::testing {

struct SyntheticRun {
  Image lit;
  Image composite;
  RayRecord record;
  std::vector<Verdict> verdicts;
};

inline Verdict syntheticVerdict(int x, int y, int error_period) {
  if (error_period == 0) {
    return Verdict::kSame;
  }
  const int place = (x / 7 + y / 3 * 13) % (error_period * 8);
  switch (place) {
    case 0:
      return Verdict::kNear;
    case 3:
      return Verdict::kMissedHit;
    case 5:
      return Verdict::kFalseHit;
    case 7:
      return Verdict::kLeak;
    case 11:
      return Verdict::kAmbiguous;
    case 13:
      return Verdict::kWrong;
    default:
      return Verdict::kSame;
  }
}

// `error_period` 0: no error; else the smaller the more. `lookup_scale`: lookups at the far end of the floor.
inline SyntheticRun syntheticRun(Size size, int error_period, double lookup_scale) {
  SyntheticRun run{Image(size, {"R", "G", "B", "A"}), Image(size, {"R", "G", "B"}), {}, {}};
  run.record.size = size;
  run.record.rays.resize(run.lit.texelCount());
  run.verdicts.resize(run.lit.texelCount());
  const int horizon = size.height / 2;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const auto i =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x);
      const double u = static_cast<double>(x) / size.width;
      const double v = static_cast<double>(y) / size.height;
      const bool is_sky = v < 0.15 + 0.1 * std::sin(9.0 * u);
      const bool is_floor = y >= horizon;
      const bool is_lit_tile = (static_cast<int>(u * 16) + static_cast<int>(v * 12)) % 2 == 0;
      const float wall = is_sky ? 0.7F : (is_lit_tile ? 0.45F : 0.12F);
      const float floor = 0.08F;
      for (std::size_t c = 0; c < 3; ++c) {
        const float tint = is_sky ? 0.6F + 0.2F * static_cast<float>(c) : 1.0F - 0.3F * static_cast<float>(c);
        run.lit.at(x, y, c) = (is_floor ? floor : wall) * tint;
        const float mirrored =
            is_floor ? 0.6F * run.lit.at(x, 2 * horizon - 1 - y < 0 ? 0 : 2 * horizon - 1 - y, c) : 0.0F;
        run.composite.at(x, y, c) = run.lit.at(x, y, c) + mirrored;
      }
      RayHit& ray = run.record.rays[i];
      if (is_sky) {
        ray.ray_class = RayClass::kBackground;
      } else if (is_floor) {
        const int source = 2 * horizon - 1 - y;
        const bool hits = source >= 0 && static_cast<double>(source) / size.height > 0.25;
        ray.ray_class = hits ? RayClass::kHit : RayClass::kOffscreen;
        ray.lookups = static_cast<std::uint32_t>(1.0 + lookup_scale * (0.05 + std::pow(2.0 * v - 1.0, 2.0)));
        run.verdicts[i] = syntheticVerdict(x, y, error_period);
      }
    }
  }
  return run;
}

}  // namespace ssrkit::testing
