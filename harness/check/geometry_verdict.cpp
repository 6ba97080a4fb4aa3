#include "check/geometry_verdict.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace ssrkit {

namespace {

constexpr std::array<const char*, kGeometryVerdictCount> kGeometryVerdictNames = {
    "NONE", "TRUE_HIT", "FALSE_HIT", "MISSED_HIT", "TRUE_MISS"};

// Whether the camera's image could hold the met surface: it is inside the frustum and faces the camera.
bool canBeSeen(TrueClass true_class) {
  return true_class == TrueClass::kVisible || true_class == TrueClass::kUnsampled ||
         true_class == TrueClass::kOccluded;
}

bool isNear(int texel, double px) {
  return std::abs(texel - std::floor(px)) <= kNearTexels;
}

GeometryVerdict verdictOf(const RayHit& ray, const TrueRay& truth, const PixelProjection& projection,
                          const Image& dist_view) {
  if (truth.true_class == TrueClass::kNone) {
    return GeometryVerdict::kNone;
  }
  if (ray.ray_class != RayClass::kHit) {
    return truth.true_class == TrueClass::kVisible ? GeometryVerdict::kMissedHit : GeometryVerdict::kTrueMiss;
  }
  const bool is_inside = ray.texel_x >= 0 && ray.texel_y >= 0 && ray.texel_x < dist_view.size.width &&
                         ray.texel_y < dist_view.size.height;
  const bool is_true = is_inside && canBeSeen(truth.true_class) && isNear(ray.texel_x, truth.plane.px.x) &&
                       isNear(ray.texel_y, truth.plane.px.y) &&
                       holdsSurface(truth.plane, projection, dist_view, ray.texel_x, ray.texel_y);
  return is_true ? GeometryVerdict::kTrueHit : GeometryVerdict::kFalseHit;
}

}  // namespace

const char* name(GeometryVerdict verdict) {
  return kGeometryVerdictNames.at(static_cast<std::size_t>(verdict));
}

std::optional<GeometryVerdict> geometryVerdictFromName(std::string_view verdict_name) {
  const auto found = std::ranges::find(kGeometryVerdictNames, verdict_name);
  return found == kGeometryVerdictNames.end()
             ? std::nullopt
             : std::optional(static_cast<GeometryVerdict>(found - kGeometryVerdictNames.begin()));
}

std::vector<GeometryVerdict> compareWithGeometry(const RayRecord& record, const GeometryResult& geometry,
                                                 const OracleInput& input) {
  SSRKIT_CHECK(record.size == geometry.size() && record.size == input.dist_view->size);
  SSRKIT_CHECK_EQ(record.rays.size(), geometry.pixelCount());
  const PixelProjection projection = pixelProjection(*input.camera);
  std::vector<GeometryVerdict> verdicts(record.rays.size());
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    verdicts[i] = verdictOf(record.rays[i], geometry.at(i), projection, *input.dist_view);
  }
  return verdicts;
}

std::size_t GeometryCounts::rayCount() const {
  std::size_t sum = 0;
  for (std::size_t i = 1; i < rays.size(); ++i) {
    sum += rays.at(i);
  }
  return sum;
}

std::size_t GeometryCounts::count(GeometryVerdict verdict) const {
  std::size_t sum = 0;
  for (const auto& of_class : verdicts) {
    sum += of_class.at(static_cast<std::size_t>(verdict));
  }
  return sum;
}

GeometryCounts countByTrueClass(const GeometryResult& geometry, std::span<const GeometryVerdict> verdicts) {
  SSRKIT_CHECK_EQ(geometry.pixelCount(), verdicts.size());
  GeometryCounts counts;
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    const auto true_class = static_cast<std::size_t>(geometry.at(i).true_class);
    ++counts.rays.at(true_class);
    ++counts.verdicts.at(true_class).at(static_cast<std::size_t>(verdicts[i]));
  }
  return counts;
}

}  // namespace ssrkit
