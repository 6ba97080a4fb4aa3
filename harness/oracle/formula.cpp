#include "oracle/formula.h"

#include <cmath>
#include <cstdlib>

namespace ssrkit {

namespace {

constexpr double kEdgePx = 0.01;
constexpr double kEdgeM = 0.1;
// A hit this near to the border between two texels is left open; wider than the oracle's tolerance of a tie.
constexpr double kBorderPx = 4e-3;

}  // namespace

double ndcX(Size size, int x) {
  return 2.0 * (x + 0.5) / size.width - 1.0;
}
double ndcY(Size size, int y) {
  return 1.0 - 2.0 * (y + 0.5) / size.height;
}
double pxYOfNdc(Size size, double ndc_y) {
  return 0.5 * size.height * (1.0 - ndc_y);
}

double tangentPerPx(Size size) {
  return 2.0 / (kFocal * size.height);
}
double tangentX(Size size, int x) {
  return (x + 0.5 - 0.5 * size.width) * tangentPerPx(size);
}
double pxXOfTangent(Size size, double tangent) {
  return 0.5 * size.width + tangent / tangentPerPx(size);
}

double contactRowPx(Size size, double wall_dist) {
  return pxYOfNdc(size, -kEyeHeight * kFocal / wall_dist);
}

bool looksPastWall(Size size, int x, double wall_dist) {
  return std::abs(tangentX(size, x)) * wall_dist > kHalfWidth - kEdgeM;
}

bool isCentreNear(double centre_px, double edge_px) {
  return std::abs(centre_px - edge_px) < kEdgePx;
}
bool runsThroughCentres(double edge_px) {
  return isCentreNear(std::floor(edge_px) + 0.5, edge_px);
}
int firstAfter(double edge_px) {
  return static_cast<int>(std::floor(edge_px + 0.5));
}
int firstBefore(double edge_px) {
  return firstAfter(edge_px) - 1;
}

ExpectedRay undecided(std::string why) {
  ExpectedRay ray;
  ray.undecided = std::move(why);
  return ray;
}

ExpectedRay decided(RayClass ray_class) {
  ExpectedRay ray;
  ray.ray_class = ray_class;
  return ray;
}

Strip withThickness(Strip strip, const TraceParameters& parameters) {
  strip.thickness_m = parameters.thickness_m;
  strip.thickness_rel = parameters.thickness_rel;
  return strip;
}

ExpectedRay rayOf(const StripAnswer& answer, const LineInImage& line, Along along, int length_px,
                  RayClass miss_class) {
  if (answer.kind == StripAnswer::Kind::kUndecided) {
    return undecided(answer.why);
  }
  if (answer.kind == StripAnswer::Kind::kMiss) {
    return decided(miss_class);
  }
  const double v_hit = line.vAt(answer.u_hit);
  if (std::abs(v_hit - std::round(v_hit)) < kBorderPx) {
    return undecided("the hit lies on the border of two texels");
  }
  if (v_hit < 0.0 || v_hit > length_px) {
    return decided(RayClass::kOffscreen);
  }
  const int across = static_cast<int>(std::floor(v_hit));
  ExpectedRay ray = decided(RayClass::kHit);
  ray.texel = along == Along::kY ? Texel{across, answer.row} : Texel{answer.row, across};
  ray.px = along == Along::kY ? glm::dvec2(v_hit, answer.u_hit) : glm::dvec2(answer.u_hit, v_hit);
  ray.dist_view = 1.0 / line.invDistAt(answer.u_hit);
  ray.lookups = std::abs(answer.row - static_cast<int>(std::floor(line.u_origin))) +
                std::abs(across - static_cast<int>(std::floor(line.v_origin)));
  return ray;
}

}  // namespace ssrkit
