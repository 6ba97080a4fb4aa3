// m1 and m3: the floor is the mirror, the rays go straight up their columns.
#include <array>
#include <optional>

#include "oracle/formula.h"

namespace ssrkit {

namespace {

constexpr double kWallDist = 8.0;
constexpr double kQuadDist = 4.0;
constexpr double kQuadYLow = -0.1;  // NDC
constexpr double kQuadYHigh = 0.3;
constexpr double kQuadHalfWidth = 1.0;

LineInImage floorMirrorLine(Size size, int x, int y) {
  return {.u_origin = y + 0.5,
          .direction = -1,
          .v_origin = x + 0.5,
          .v_per_u = 0.0,
          .inv_dist_origin = -ndcY(size, y) / (kEyeHeight * kFocal),
          .inv_dist_per_u = 1.0 / (size.height * kEyeHeight * kFocal)};
}

// What m1 and m3 say before any ray: nothing for a ray that is walked.
std::optional<ExpectedRay> floorMirrorPixel(Size size, int x, int y) {
  const double contact_px = contactRowPx(size, kWallDist);
  if (looksPastWall(size, x, kWallDist)) {
    return undecided("the column lies beyond the scene's sides");
  }
  if (isCentreNear(y + 0.5, contact_px)) {
    return undecided("the floor meets the wall at the texel's centre");
  }
  if (y + 0.5 < contact_px) {
    return decided(RayClass::kMasked);
  }
  return std::nullopt;
}

}  // namespace

ExpectedRay expectedM1(Size size, const TraceParameters& parameters, int x, int y) {
  if (const std::optional<ExpectedRay> early = floorMirrorPixel(size, x, y)) {
    return *early;
  }
  const LineInImage line = floorMirrorLine(size, x, y);
  const Strip wall = withThickness(
      {.first = firstBefore(contactRowPx(size, kWallDist)), .last = 0, .inv_dist_zero = 1.0 / kWallDist},
      parameters);
  return rayOf(firstHit(line, wall), line, Along::kY, size.width, RayClass::kRange);
}

ExpectedRay expectedM3(Size size, const TraceParameters& parameters, int x, int y) {
  if (const std::optional<ExpectedRay> early = floorMirrorPixel(size, x, y)) {
    return *early;
  }
  const double right_px = pxXOfTangent(size, kQuadHalfWidth / kQuadDist);
  const double left_px = pxXOfTangent(size, -kQuadHalfWidth / kQuadDist);
  if (isCentreNear(x + 0.5, left_px) || isCentreNear(x + 0.5, right_px)) {
    return undecided("the quad's side runs through the column's centres");
  }
  if (x + 0.5 < left_px || x + 0.5 > right_px) {
    return expectedM1(size, parameters, x, y);
  }
  const double low_px = pxYOfNdc(size, kQuadYLow);
  const double high_px = pxYOfNdc(size, kQuadYHigh);
  if (runsThroughCentres(low_px) || runsThroughCentres(high_px)) {
    return undecided("the quad's edge runs through a row's centres");
  }
  const LineInImage line = floorMirrorLine(size, x, y);
  const int below_quad = firstBefore(contactRowPx(size, kWallDist));
  const std::array strips = {
      Strip{.first = below_quad, .last = firstAfter(low_px), .inv_dist_zero = 1.0 / kWallDist},
      Strip{.first = firstBefore(low_px), .last = firstAfter(high_px), .inv_dist_zero = 1.0 / kQuadDist},
      Strip{.first = firstBefore(high_px), .last = 0, .inv_dist_zero = 1.0 / kWallDist}};
  StripAnswer answer;
  for (const Strip& strip : strips) {
    answer = firstHit(line, withThickness(strip, parameters));
    if (answer.kind != StripAnswer::Kind::kMiss) {
      break;
    }
  }
  return rayOf(answer, line, Along::kY, size.width, RayClass::kRange);
}

}  // namespace ssrkit
