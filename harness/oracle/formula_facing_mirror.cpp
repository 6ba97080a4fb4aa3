// m2: a mirror across the view, its rays come back towards the camera and down to the floor.
#include "oracle/formula.h"

namespace ssrkit {

namespace {

constexpr double kFacingMirrorDist = 4.0;

}  // namespace

ExpectedRay expectedM2(Size size, const TraceParameters& parameters, int x, int y) {
  const double contact_px = contactRowPx(size, kFacingMirrorDist);
  if (looksPastWall(size, x, kFacingMirrorDist)) {
    return undecided("the column lies beyond the scene's sides");
  }
  if (isCentreNear(y + 0.5, contact_px)) {
    return undecided("the floor meets the mirror at the texel's centre");
  }
  if (y + 0.5 > contact_px) {
    return decided(RayClass::kMasked);
  }
  const double ndc_y = ndcY(size, y);
  if (ndc_y >= 0.0) {
    return decided(RayClass::kOffscreen);  // it rises, away from the floor
  }
  // On the way down the image X and Y grow in proportion.
  const LineInImage line{.u_origin = y + 0.5,
                         .direction = 1,
                         .v_origin = x + 0.5,
                         .v_per_u = -ndcX(size, x) / ndc_y * size.width / size.height,
                         .inv_dist_origin = 1.0 / kFacingMirrorDist,
                         .inv_dist_per_u = 1.0 / (size.height * kFacingMirrorDist * -ndc_y)};
  const Strip floor = withThickness({.first = firstAfter(contact_px),
                                     .last = size.height - 1,
                                     .inv_dist_zero = -1.0 / (kEyeHeight * kFocal),
                                     .inv_dist_per_row = 2.0 / (size.height * kEyeHeight * kFocal)},
                                    parameters);
  return rayOf(firstHit(line, floor), line, Along::kY, size.width, RayClass::kOffscreen);
}

}  // namespace ssrkit
