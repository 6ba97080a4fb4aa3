// What the formulas of the closed forms share: the scenes' common constants, their camera and the making of
// answers.
#pragma once

#include <string>

#include "base/size.h"
#include "oracle/closed_form.h"
#include "oracle/strip.h"

namespace ssrkit {

// Of scenes/kit/closed_form.py, in metres.
inline constexpr double kFocal = 2.0;       // cot(fov_y / 2)
inline constexpr double kEyeHeight = 1.0;   // over the floor
inline constexpr double kHalfWidth = 12.0;  // of floors and walls

// Texel centres in NDC, and back to pixel positions.
[[nodiscard]] double ndcX(Size size, int x);
[[nodiscard]] double ndcY(Size size, int y);
[[nodiscard]] double pxYOfNdc(Size size, double ndc_y);
// p_view.x / dist_view, from the height alone: the aspect ratio is the image's own.
[[nodiscard]] double tangentPerPx(Size size);
[[nodiscard]] double tangentX(Size size, int x);
[[nodiscard]] double pxXOfTangent(Size size, double tangent);
// The pixel row where the floor meets a frontal wall.
[[nodiscard]] double contactRowPx(Size size, double wall_dist);

// Whether a texel's column may look past the ends of a wall at this distance.
[[nodiscard]] bool looksPastWall(Size size, int x, double wall_dist);
// Rasterisers snap edges to a fraction of a pixel: whether a centre may fall on either side of an edge.
[[nodiscard]] bool isCentreNear(double centre_px, double edge_px);
// Whether an edge of the scene runs through the centres of a whole row or column of texels.
[[nodiscard]] bool runsThroughCentres(double edge_px);
// The first row or column whose centre lies beyond the edge, towards larger and smaller coordinates.
[[nodiscard]] int firstAfter(double edge_px);
[[nodiscard]] int firstBefore(double edge_px);

[[nodiscard]] ExpectedRay undecided(std::string why);
[[nodiscard]] ExpectedRay decided(RayClass ray_class);
[[nodiscard]] Strip withThickness(Strip strip, const TraceParameters& parameters);

// Which coordinate of the image a line's u is.
enum class Along { kX, kY };

// The ray that the strip's answer makes. A hit outside the image, `length_px` across the line, is none.
[[nodiscard]] ExpectedRay rayOf(const StripAnswer& answer, const LineInImage& line, Along along,
                                int length_px, RayClass miss_class);

// The scenes, each in its own file.
[[nodiscard]] ExpectedRay expectedM1(Size size, const TraceParameters& parameters, int x, int y);
[[nodiscard]] ExpectedRay expectedM2(Size size, const TraceParameters& parameters, int x, int y);
[[nodiscard]] ExpectedRay expectedM3(Size size, const TraceParameters& parameters, int x, int y);
[[nodiscard]] ExpectedRay expectedM4(Size size, const TraceParameters& parameters, int x, int y);

}  // namespace ssrkit
