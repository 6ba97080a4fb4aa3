// What every tracer and Oracle A write for each pixel: hit.exr on the disk, `RayRecord` in memory.
#pragma once

#include <cstdint>
#include <vector>

#include "base/error.h"
#include "base/size.h"
#include "image/image.h"

namespace ssrkit {

// Outcome class of a ray. The numbers are part of the file format (docs/formats.md).
enum class RayClass : std::uint8_t {
  kMasked = 0,      // not reflective: costs no lookup
  kBackground = 1,  // the pixel itself is background
  kHit = 2,
  kOffscreen = 3,    // left the image or crossed the near plane
  kRange = 4,        // reached max_distance_m
  kBudget = 5,       // lookup budget spent
  kIntoSurface = 6,  // the direction points below the geometric surface
};
inline constexpr int kRayClassCount = 7;

// A shader of somebody's own may write another number, which a record in memory keeps: the checks tell it.
inline constexpr int kLastRayClassNumber = 255;
[[nodiscard]] constexpr bool isKnown(RayClass ray_class) {
  return static_cast<int>(ray_class) < kRayClassCount;
}

[[nodiscard]] const char* name(RayClass ray_class);  // "HIT"; "no class" of one that is not known

// Whether no ray left the pixel. A ray into the surface is one, though it costs nothing.
[[nodiscard]] constexpr bool hasNoRay(RayClass ray_class) {
  return ray_class == RayClass::kMasked || ray_class == RayClass::kBackground;
}

struct RayHit {
  std::int32_t texel_x = -1;  // -1: none
  std::int32_t texel_y = -1;
  float px_x = -1.0F;  // hit position in pixels
  float px_y = -1.0F;
  float t_m = -1.0F;  // metres along the ray
  RayClass ray_class = RayClass::kMasked;
  std::uint32_t lookups = 0;  // reads of the depth buffer or pyramid
  std::uint32_t steps = 0;    // iterations of the march
};

[[nodiscard]] constexpr bool isHit(const RayHit& ray) {
  return ray.ray_class == RayClass::kHit;
}

struct RayRecord {
  Size size;
  std::vector<RayHit> rays;  // row by row from the upper left

  [[nodiscard]] const RayHit& at(int x, int y) const {
    return rays[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                static_cast<std::size_t>(x)];
  }
};

// The channels of hit.exr: texel.x texel.y px.x px.y t_m class lookups steps.
[[nodiscard]] Image toImage(const RayRecord& record);

// Fails when channels are missing or a value is not what its channel may hold. `where` names the file.
[[nodiscard]] Expected<RayRecord> rayRecordFromImage(const Image& image, const std::string& where);

}  // namespace ssrkit
