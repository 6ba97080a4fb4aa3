// Oracle B: what the reflected ray of each pixel truly meets among the scene's triangles, and whether the
// depth image can know it (docs/techniques.md, "What screen space can and cannot know"). Oracle A knows the
// depth image and nothing else; the difference of the two is the limit of screen space, not a tracer's error.
#pragma once

#include "base/error.h"
#include "image/image.h"
#include "oracle/geometry_result.h"
#include "oracle/oracle.h"
#include "oracle/true_surfaces.h"

namespace ssrkit {

// Whether a texel of the depth image shows this surface. A depth image knows a point to half a texel in every
// direction: the depths must agree at the texel's centre to within half a texel's slope, half a texel's width
// in metres, and the precision of the depth itself.
[[nodiscard]] bool holdsSurface(const PlaneInImage& plane, const PixelProjection& projection,
                                const Image& dist_view, int x, int y);

// The whole image, on `thread_count` threads (0: one for each core). Each ray is the very ray that Oracle A
// walks, in the world instead of the image. `surfaces` must be built for the camera's view. Fails where
// checkInput does.
[[nodiscard]] Expected<GeometryResult> traceGeometry(const OracleInput& input, const TrueSurfaces& surfaces,
                                                     int thread_count = 0);

// dist_view of what the camera truly sees at each texel's centre, +inf for background: the G-buffer without a
// rasteriser.
[[nodiscard]] Image trueDistView(const Camera& camera, const TrueSurfaces& surfaces, int thread_count = 0);

}  // namespace ssrkit
