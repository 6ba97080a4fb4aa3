// m4: a mirror at 45 degrees, its rays cross the view to a side wall.
#include <optional>

#include "oracle/formula.h"

namespace ssrkit {

namespace {

constexpr double kSlantAxisDist = 4.0;  // on the camera's axis
constexpr double kSlantLeft = -1.0;     // x of the mirror's edges
constexpr double kSlantRight = 0.75;
constexpr double kSlantHalfHeight = 1.0;
constexpr double kSideWallX = 1.0;
constexpr double kBackWallDist = 10.0;

// The slanted mirror x + z = -D is seen at dist_view D / (1 - tangent).
double slantDist(double tangent) {
  return kSlantAxisDist / (1.0 - tangent);
}
double slantPx(Size size, double slant_x) {
  return pxXOfTangent(size, slant_x / (kSlantAxisDist + slant_x));
}

// What m4 says before any ray: nothing for a ray that is walked.
std::optional<ExpectedRay> slantPixel(Size size, int x, int y) {
  const double tangent = tangentX(size, x);
  if (looksPastWall(size, x, kBackWallDist)) {
    return undecided("the column lies beyond the scene's sides");
  }
  const double left_px = slantPx(size, kSlantLeft);
  const double right_px = slantPx(size, kSlantRight);
  const double half_height = kFocal * kSlantHalfHeight / slantDist(tangent);
  const double top_px = pxYOfNdc(size, half_height);
  const double bottom_px = pxYOfNdc(size, -half_height);
  if (isCentreNear(x + 0.5, left_px) || isCentreNear(x + 0.5, right_px) || isCentreNear(y + 0.5, top_px) ||
      isCentreNear(y + 0.5, bottom_px)) {
    return undecided("the mirror's edge runs through the texel's centre");
  }
  if (x + 0.5 < left_px || x + 0.5 > right_px || y + 0.5 < top_px || y + 0.5 > bottom_px) {
    return decided(RayClass::kMasked);
  }
  return std::nullopt;
}

// From the mirror in the direction (1, Y/f, -tangent).
LineInImage slantLine(Size size, int x, int y) {
  const double tangent = tangentX(size, x);
  const double inv_dist_origin = 1.0 / slantDist(tangent);
  return {.u_origin = x + 0.5,
          .direction = 1,
          .v_origin = y + 0.5,
          .v_per_u = -0.5 * size.height * ndcY(size, y) / (1.0 + tangent) * tangentPerPx(size),
          .inv_dist_origin = inv_dist_origin,
          .inv_dist_per_u = -tangent * inv_dist_origin / (1.0 - tangent * tangent) * tangentPerPx(size)};
}

}  // namespace

ExpectedRay expectedM4(Size size, const TraceParameters& parameters, int x, int y) {
  if (const std::optional<ExpectedRay> early = slantPixel(size, x, y)) {
    return *early;
  }
  const LineInImage line = slantLine(size, x, y);
  // Between the mirror's right edge and the wall's foot the ray is in front of all that it passes.
  const Strip wall = withThickness({.first = firstAfter(slantPx(size, kSlantRight)),
                                    .last = size.width - 1,
                                    .inv_dist_zero = -0.5 * size.width * tangentPerPx(size) / kSideWallX,
                                    .inv_dist_per_row = tangentPerPx(size) / kSideWallX},
                                   parameters);
  const StripAnswer answer = firstHit(line, wall);
  const double u_end = answer.kind == StripAnswer::Kind::kHit ? answer.u_hit : size.width;
  // The floor is seen below Y = -f h tangent / x_w; a ray that comes within two texels of it may meet it
  // first.
  const double floor_px =
      pxYOfNdc(size, -kFocal * kEyeHeight / kSideWallX * tangentPerPx(size) * (u_end - 0.5 * size.width));
  if (line.vAt(u_end) > floor_px - 2.0) {
    return undecided("the ray comes too near to the floor");
  }
  return rayOf(answer, line, Along::kX, size.height, RayClass::kOffscreen);
}

}  // namespace ssrkit
