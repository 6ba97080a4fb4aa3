#include "oracle/cell_walk.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "oracle/watch.h"

namespace ssrkit {

namespace {

// Where the ray enters the overlap with the column.
double sigmaOfHit(const ImageRay& ray, const Column& column, const Visit& visit) {
  const bool is_behind_front = visit.inv_dist_in * column.near_dist <= 1.0;
  if (is_behind_front && visit.inv_dist_in * column.far_dist > 1.0) {
    return visit.sigma_in;
  }
  const double inv_dist = 1.0 / (is_behind_front ? column.far_dist : column.near_dist);
  return std::clamp((inv_dist - ray.inv_dist_origin) / ray.inv_dist_per_sigma, visit.sigma_in,
                    visit.sigma_out);
}

RayHit hitAt(const ImageRay& ray, const Column& column, const Visit& visit) {
  const double sigma = sigmaOfHit(ray, column, visit);
  const glm::dvec2 px = ray.pxAt(sigma);
  RayHit hit;
  hit.texel_x = column.x;
  hit.texel_y = column.y;
  hit.px_x = static_cast<float>(px.x);
  hit.px_y = static_cast<float>(px.y);
  hit.t_m = static_cast<float>(ray.tMetresAt(sigma));
  hit.ray_class = RayClass::kHit;
  return hit;
}

// The walk of one ray with its watch for ties. Once a tie is seen the rest is walked without watching.
class WatchedWalk {
 public:
  WatchedWalk(const ColumnField& field, const ImageRay& ray, int own_x, int own_y)
      : field_(field), ray_(ray), own_x_(own_x), own_y_(own_y), watch_(ray) {}

  WalkResult run();

 private:
  [[nodiscard]] bool isOwn(const CellStep& cell) const { return cell.x == own_x_ && cell.y == own_y_; }
  [[nodiscard]] bool isWatching() const { return ambiguity_ == Ambiguity::kNone; }
  void flag(Ambiguity ambiguity) {
    ambiguity_ = ambiguity;
    watch_ = Watch();
  }
  bool isHit(const Column& column, const Visit& visit);
  void flagTieAt(int x, int y);
  void lookBeside(const CellStep& cell);
  void lookPastEnd(const CellStep& cell);
  void lookAlongEdge(int last_x, int last_y);
  bool endWith(RayHit hit, const CellStep& last);
  bool endWith(RayClass ray_class, const CellStep& last);
  bool lookClosely(CellStep cell, Visit visit, std::uint32_t lookups);

  const ColumnField& field_;
  const ImageRay& ray_;
  int own_x_;
  int own_y_;
  Watch watch_;
  Ambiguity ambiguity_ = Ambiguity::kNone;
  std::uint32_t lookups_ = 0;
  WalkResult result_;
};

bool WatchedWalk::isHit(const Column& column, const Visit& visit) {
  if (isWatching() && overlapWithTolerance(ray_, column).isTie()) {
    flag(kindOfTie(ray_, column));
  }
  return overlaps(column, visit.inv_dist_in, visit.inv_dist_out);
}

void WatchedWalk::flagTieAt(int x, int y) {
  if (!isWatching() || !field_.contains(x, y) || (x == own_x_ && y == own_y_)) {
    return;
  }
  const Column column = field_.column(x, y);
  if (overlapWithTolerance(ray_, column).isTie()) {
    flag(kindOfTie(ray_, column));
  }
}

// The texel that the ray misses on the other side of a corner.
void WatchedWalk::lookBeside(const CellStep& cell) {
  if (cell.leavesAlongX()) {
    flagTieAt(cell.x, cell.y + cell.dy);
  } else {
    flagTieAt(cell.x + cell.dx, cell.y);
  }
}

// The texels that the ray would enter if it were a little longer.
void WatchedWalk::lookPastEnd(const CellStep& cell) {
  const int next_x = cell.x + cell.dx;
  const int next_y = cell.y + cell.dy;
  for (const auto& [x, y] :
       {std::array{next_x, cell.y}, std::array{cell.x, next_y}, std::array{next_x, next_y}}) {
    flagTieAt(x, y);
    if (isWatching() && lookups_ == field_.lookup_budget && field_.contains(x, y) &&
        overlapWithTolerance(ray_, field_.column(x, y)).is_touched) {
      flag(Ambiguity::kEnd);
    }
  }
}

// All texels around the origin, and on both sides of the way.
void WatchedWalk::lookAlongEdge(int last_x, int last_y) {
  CellStep cell(ray_);
  for (int y = cell.y - 1; y <= cell.y + 1; ++y) {
    for (int x = cell.x - 1; x <= cell.x + 1; ++x) {
      flagTieAt(x, y);
    }
  }
  const int side_x = minorAxis(ray_) == 0 ? 1 : 0;
  const int side_y = 1 - side_x;
  while (isWatching()) {
    flagTieAt(cell.x + side_x, cell.y + side_y);
    flagTieAt(cell.x - side_x, cell.y - side_y);
    if ((cell.x == last_x && cell.y == last_y) || !(cell.sigmaOut() < ray_.sigma_end)) {
      return;
    }
    cell.step(ray_);
  }
}

bool WatchedWalk::endWith(RayHit hit, const CellStep& last) {
  if (isWatching() && runsAlongEdge(ray_)) {
    lookAlongEdge(last.x, last.y);
  }
  hit.lookups = lookups_;
  hit.steps = lookups_;
  result_ = {.hit = hit, .ambiguity = ambiguity_};
  return true;
}

bool WatchedWalk::endWith(RayClass ray_class, const CellStep& last) {
  RayHit miss;
  miss.ray_class = ray_class;
  return endWith(miss, last);
}

// Everything about one cell that is not for every cell. True when the walk is over.
bool WatchedWalk::lookClosely(CellStep cell, Visit visit, std::uint32_t lookups) {
  lookups_ = lookups;
  if (!isOwn(cell)) {
    if (lookups_ == field_.lookup_budget) {
      if (isWatching() && (ray_.sigma_end - visit.sigma_in) * glm::length(ray_.px_per_sigma) <= kTiePx) {
        flag(Ambiguity::kEnd);
      }
      return endWith(RayClass::kBudget, cell);
    }
    ++lookups_;
    const Column column = field_.column(cell.x, cell.y);
    if (watch_.isWorthALook(column, visit) && isHit(column, visit)) {
      return endWith(hitAt(ray_, column, visit), cell);
    }
  }
  if (watch_.isAtCorner(cell.sigma_x, cell.sigma_y)) {
    lookBeside(cell);
  }
  if (cell.sigmaOut() < ray_.sigma_end) {
    return false;
  }
  lookPastEnd(cell);
  return endWith(ray_.end_class, cell);
}

WalkResult WatchedWalk::run() {
  // Copies that nobody else can see stay in registers: this loop is the oracle's cost.
  const ImageRay ray = ray_;
  const ColumnField field = field_;
  Watch watch = watch_;
  CellStep cell(ray);
  std::uint32_t lookups = 0;
  double sigma_in = 0.0;
  double inv_dist_in = ray.inv_dist_origin;
  for (;;) {
    const double sigma_next = cell.sigmaOut();
    const bool is_last = !(sigma_next < ray.sigma_end);
    const double sigma_out = is_last ? ray.sigma_end : sigma_next;
    const Visit visit{sigma_in, sigma_out, inv_dist_in, ray.invDistAt(sigma_out)};
    if (is_last || lookups == field.lookup_budget || watch.isAtCorner(cell.sigma_x, cell.sigma_y) ||
        watch.isWorthALook(field.column(cell.x, cell.y), visit)) [[unlikely]] {
      if (lookClosely(cell, visit, lookups)) {
        return result_;
      }
      watch = watch_;
    }
    lookups += isOwn(cell) ? 0 : 1;
    sigma_in = visit.sigma_out;
    inv_dist_in = visit.inv_dist_out;
    cell.step(ray);
  }
}

}  // namespace

CellStep::CellStep(const ImageRay& ray)
    : x(static_cast<int>(std::floor(ray.px_origin.x))),
      y(static_cast<int>(std::floor(ray.px_origin.y))),
      dx(ray.px_per_sigma.x < 0.0 ? -1 : 1),
      dy(ray.px_per_sigma.y < 0.0 ? -1 : 1),
      sigma_x(ray.sigmaAt(0, x + (dx > 0 ? 1 : 0))),
      sigma_y(ray.sigmaAt(1, y + (dy > 0 ? 1 : 0))) {}

ColumnField columnField(const OracleInput& input) {
  return {.dist_view = input.dist_view->data.data(),
          .size = input.dist_view->size,
          .far_scale = 1.0 + input.parameters.thickness_rel,
          .thickness_m = input.parameters.thickness_m,
          .lookup_budget = static_cast<std::uint32_t>(input.parameters.lookup_budget)};
}

WalkResult walkRay(const ColumnField& field, const ImageRay& ray, int own_x, int own_y) {
  return WatchedWalk(field, ray, own_x, own_y).run();
}

}  // namespace ssrkit
