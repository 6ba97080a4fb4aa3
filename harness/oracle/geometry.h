// Oracle B: what the reflected ray of each pixel truly meets among the scene's triangles, and whether the
// depth image can know it (docs/techniques.md, "What screen space can and cannot know"). Oracle A knows the
// depth image and nothing else; the difference of the two is the limit of screen space, not a tracer's error.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "image/image.h"
#include "oracle/oracle.h"
#include "oracle/true_surfaces.h"

namespace ssrkit {

// The numbers are part of the file format (docs/formats.md). In the order in which they are asked, from the
// last.
enum class TrueClass : std::uint8_t {
  kNone = 0,       // no ray: MASKED, BACKGROUND or INTO_SURFACE
  kVisible = 1,    // the depth image holds the met surface in the texel where it is seen
  kUnsampled = 2,  // the camera sees the met point, but the texel's centre shows something else
  kOccluded = 3,   // something stands between the camera and the met point
  kBackface = 4,   // the ray meets the side of a surface that faces away from the camera
  kOffscreen = 5,  // the ray meets a surface outside the image, before the near plane or beyond the far one
  kSky = 6,        // the ray meets nothing within max_distance_m
};
inline constexpr int kTrueClassCount = 7;

[[nodiscard]] const char* name(TrueClass true_class);  // "OFFSCREEN_TRUE" for kOffscreen
[[nodiscard]] std::optional<TrueClass> trueClassFromName(std::string_view class_name);

// The plane of a surface as the image sees it: 1/dist_view is linear in p_px.
struct PlaneInImage {
  glm::dvec2 px{0.0};     // where the ray meets it
  double inv_dist = 0.0;  // 1/dist_view there
  glm::dvec2 inv_dist_per_px{0.0};
};

// What the ray of one pixel meets.
struct TrueRay {
  TrueClass true_class = TrueClass::kNone;
  double t_m = -1.0;       // metres along the ray; -1 where it meets nothing
  double dist_view = 0.0;  // of the met point, negative behind the camera; 0 where it meets nothing
  PlaneInImage plane;      // where dist_view is over 0
};

struct GeometryResult {
  Size size;
  std::vector<TrueRay> rays;  // row by row from the upper left

  [[nodiscard]] const TrueRay& at(int x, int y) const {
    return rays[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                static_cast<std::size_t>(x)];
  }
};

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
