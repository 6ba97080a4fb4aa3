// What Oracle B finds: for each pixel what its reflected ray truly meets.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/size.h"

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

// One TrueRay for each pixel. Only those with a ray are stored whole: of most images the larger part has
// none, and takes two bytes a pixel.
class GeometryResult {
 public:
  GeometryResult() = default;
  // No pixel has a ray. No side may be over 65,535 texels (checked).
  explicit GeometryResult(Size size);

  // `rays` has the image's width (checked); one whose class is kNone is stored as TrueRay{}. Different rows
  // may be set from different threads at once.
  void setRow(int y, std::span<const TrueRay> rays);

  [[nodiscard]] Size size() const { return size_; }
  [[nodiscard]] std::size_t pixelCount() const { return places_.size(); }
  [[nodiscard]] const TrueRay& at(int x, int y) const;
  // By its number, row by row from the upper left.
  [[nodiscard]] const TrueRay& at(std::size_t pixel) const;

 private:
  using Place = std::uint16_t;  // among the rays of its row, from 1; 0: no ray

  [[nodiscard]] const TrueRay& rayAt(Place place, std::size_t y) const;

  Size size_;
  std::vector<Place> places_;  // one a pixel
  std::vector<std::vector<TrueRay>> rays_of_row_;
};

}  // namespace ssrkit
