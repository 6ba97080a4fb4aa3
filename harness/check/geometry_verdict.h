// A pixel's verdict against the true geometry: what the answer is worth, whatever the depth image says.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "image/ray_record.h"
#include "oracle/geometry.h"

namespace ssrkit {

enum class GeometryVerdict : std::uint8_t {
  kNone,      // there is no ray
  kTrueHit,   // the hit texel shows the surface that the ray truly meets, within kNearTexels of where it does
  kFalseHit,  // a hit that is not
  kMissedHit,  // no hit, though the met surface is VISIBLE
  kTrueMiss,   // no hit, and the depth image could not have told
};
inline constexpr int kGeometryVerdictCount = 5;

// On either axis. Columns are flat: where a ray all but follows a surface it enters another column than the
// one that is truly met, a texel or two away.
inline constexpr int kNearTexels = 2;

[[nodiscard]] const char* name(GeometryVerdict verdict);  // "TRUE_HIT"
[[nodiscard]] std::optional<GeometryVerdict> geometryVerdictFromName(std::string_view verdict_name);

// One verdict a pixel. `input` is what the geometry was traced from; all sizes agree (checked).
[[nodiscard]] std::vector<GeometryVerdict> compareWithGeometry(const RayRecord& record,
                                                               const GeometryResult& geometry,
                                                               const OracleInput& input);

// The rays of one trace by what they truly meet: how many there are, and their verdicts.
struct GeometryCounts {
  std::array<std::size_t, kTrueClassCount> rays{};
  std::array<std::array<std::size_t, kGeometryVerdictCount>, kTrueClassCount> verdicts{};

  [[nodiscard]] std::size_t rayCount() const;  // kNone not counted
  [[nodiscard]] std::size_t count(GeometryVerdict verdict) const;
};
[[nodiscard]] GeometryCounts countByTrueClass(const GeometryResult& geometry,
                                              std::span<const GeometryVerdict> verdicts);

}  // namespace ssrkit
