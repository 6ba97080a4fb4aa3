// The solver under the closed forms: a straight line in the image against a run of texel rows (or columns)
// whose inverse depth is linear. It solves one linear inequality for the whole run; it walks nothing.
#pragma once

#include <glm/glm.hpp>
#include <optional>

namespace ssrkit {

// A ray by its coordinate u along one axis of the image: u runs from u_origin in `direction`, the other
// coordinate and 1/dist_view are linear in it.
struct LineInImage {
  double u_origin = 0.0;
  int direction = 1;  // +1 or -1
  double v_origin = 0.0;
  double v_per_u = 0.0;
  double inv_dist_origin = 0.0;
  double inv_dist_per_u = 0.0;

  [[nodiscard]] double vAt(double u) const { return v_origin + (u - u_origin) * v_per_u; }
  [[nodiscard]] double invDistAt(double u) const { return inv_dist_origin + (u - u_origin) * inv_dist_per_u; }
};

// Rows k from `first` to `last` in the ray's direction, with 1/dist_view = inv_dist_zero + (k + .5) *
// inv_dist_per_row at every texel of row k; empty when `last` lies before `first`.
struct Strip {
  int first = 0;
  int last = -1;
  double inv_dist_zero = 0.0;
  double inv_dist_per_row = 0.0;
  double thickness_m = 0.0;
  double thickness_rel = 0.0;
};

struct StripAnswer {
  enum class Kind { kHit, kMiss, kUndecided };
  Kind kind = Kind::kMiss;
  int row = 0;           // of a hit
  double u_hit = 0.0;    // where the ray enters the overlap
  const char* why = "";  // of an undecided one
};

// The first row of the strip that the ray meets by the tracing contract. Undecided where two rows, or hit and
// miss, are nearer than the oracle's tolerances.
[[nodiscard]] StripAnswer firstHit(const LineInImage& line, const Strip& strip);

}  // namespace ssrkit
