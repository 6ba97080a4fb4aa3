#include "oracle/strip.h"

#include <algorithm>
#include <cmath>

namespace ssrkit {

namespace {

// A little wider than the oracle's own tolerances of a tie (oracle/image_ray.h): what is decided here is
// never ambiguous there.
constexpr double kMarginPx = 4e-3;
constexpr double kMarginRelative = 4e-5;

constexpr const char* kRowTie = "two rows tie";
constexpr const char* kThicknessTie = "the column's far side ties";
constexpr const char* kThinColumn = "the column is thinner than the ray's step in depth";

double edgeIn(const LineInImage& line, int row) {
  return line.direction > 0 ? row : row + 1;
}

// 1/dist_view where the ray is farthest inside the row.
double lowestInvDist(const LineInImage& line, int row) {
  const double u_in = edgeIn(line, row);
  return std::min(line.invDistAt(u_in), line.invDistAt(u_in + line.direction));
}

double stripInvDist(const Strip& strip, int row) {
  return strip.inv_dist_zero + (row + 0.5) * strip.inv_dist_per_row;
}

// How much farther than the column's front the ray gets in the row, in 1/m; linear in the row.
double reach(const LineInImage& line, const Strip& strip, int row) {
  return stripInvDist(strip, row) - lowestInvDist(line, row);
}

double margin(const LineInImage& line, const Strip& strip, int row) {
  return kMarginRelative * std::abs(stripInvDist(strip, row)) + kMarginPx * std::abs(line.inv_dist_per_u);
}

StripAnswer undecidedStrip(const char* why) {
  return {.kind = StripAnswer::Kind::kUndecided, .why = why};
}

// The ray reaches the front of this row first: it hits unless it is behind the column's back by then.
StripAnswer hitInRow(const LineInImage& line, const Strip& strip, int row) {
  const double u_in = edgeIn(line, row);
  const double inv_dist_in = line.invDistAt(u_in);
  const double inv_dist_out = line.invDistAt(u_in + line.direction);
  const double inv_dist_front = stripInvDist(strip, row);
  const double dist_back = (1.0 + strip.thickness_rel) / inv_dist_front + strip.thickness_m;
  const double inv_dist_back = 1.0 / dist_back;
  const double clearance = std::max(inv_dist_in, inv_dist_out) - inv_dist_back;
  if (std::abs(clearance) <= margin(line, strip, row) && std::isfinite(dist_back)) {
    return undecidedStrip(kThicknessTie);
  }
  if (clearance <= 0.0) {
    const bool moves_on_behind = strip.inv_dist_per_row == 0.0 && inv_dist_out <= inv_dist_in;
    return moves_on_behind ? StripAnswer{} : undecidedStrip(kThinColumn);
  }
  StripAnswer answer{.kind = StripAnswer::Kind::kHit, .row = row, .u_hit = u_in};
  if (inv_dist_in > inv_dist_front) {
    answer.u_hit = line.u_origin + (inv_dist_front - line.inv_dist_origin) / line.inv_dist_per_u;
  } else if (inv_dist_in <= inv_dist_back) {
    answer.u_hit = line.u_origin + (inv_dist_back - line.inv_dist_origin) / line.inv_dist_per_u;
  }
  return answer;
}

}  // namespace

StripAnswer firstHit(const LineInImage& line, const Strip& strip) {
  const int count = (strip.last - strip.first) * line.direction + 1;
  if (count <= 0) {
    return {};
  }
  const double at_first = reach(line, strip, strip.first);
  const double per_row = reach(line, strip, strip.first + line.direction) - at_first;
  int rows_on = 0;
  if (at_first < 0.0) {
    if (per_row <= 0.0) {
      return at_first < -margin(line, strip, strip.first) ? StripAnswer{} : undecidedStrip(kRowTie);
    }
    rows_on = static_cast<int>(std::clamp(std::ceil(-at_first / per_row), 0.0, 1.0 * count));
  }
  const int row = strip.first + rows_on * line.direction;
  const bool ties_before =
      rows_on > 0 && reach(line, strip, row - line.direction) > -margin(line, strip, row - line.direction);
  const bool ties_here = rows_on < count && reach(line, strip, row) < margin(line, strip, row);
  if (ties_before || ties_here) {
    return undecidedStrip(kRowTie);
  }
  return rows_on < count ? hitInRow(line, strip, row) : StripAnswer{};
}

}  // namespace ssrkit
