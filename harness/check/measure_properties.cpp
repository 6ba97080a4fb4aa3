#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "check/measure.h"
#include "check/ray_pairs.h"

namespace ssrkit {

namespace {

constexpr float kEdgeSlackPx = 1.0F / 128.0F;  // 2^-7 px: rounding of a position at 16384 px is 2^-10

using Violates = bool (*)(const RayHit& ray, const Answer& self, int x, int y);

bool isNotFinite(const RayHit& ray, const Answer& /*self*/, int /*x*/, int /*y*/) {
  return !std::isfinite(ray.px_x) || !std::isfinite(ray.px_y) || !std::isfinite(ray.t_m) ||
         (isHit(ray) && ray.t_m < 0.0F);
}

bool isSelfHit(const RayHit& ray, const Answer& /*self*/, int x, int y) {
  return isHit(ray) && ray.texel_x == x && ray.texel_y == y;
}

bool isPointOffTexel(const RayHit& ray, const Answer& /*self*/, int /*x*/, int /*y*/) {
  const auto outside = [](float px, int texel) {
    const auto low = static_cast<float>(texel);
    return !(px >= low - kEdgeSlackPx && px <= low + 1.0F + kEdgeSlackPx);
  };
  return isHit(ray) && (outside(ray.px_x, ray.texel_x) || outside(ray.px_y, ray.texel_y));
}

bool isOffImage(const RayHit& ray, const Answer& self, int /*x*/, int /*y*/) {
  const auto width = static_cast<float>(self.size.width);
  const auto height = static_cast<float>(self.size.height);
  const bool texel_inside =
      ray.texel_x >= 0 && ray.texel_y >= 0 && ray.texel_x < self.size.width && ray.texel_y < self.size.height;
  const bool point_inside = ray.px_x >= 0.0F && ray.px_y >= 0.0F && ray.px_x <= width && ray.px_y <= height;
  return isHit(ray) && !(texel_inside && point_inside);
}

bool isOverBudget(const RayHit& ray, const Answer& self, int /*x*/, int /*y*/) {
  return ray.lookups > static_cast<std::uint32_t>(self.parameters.lookup_budget);
}

// One of the classes; a texel if and only if there is a hit; nothing spent on pixels without a ray.
bool isInconsistent(const RayHit& ray, const Answer& /*self*/, int /*x*/, int /*y*/) {
  const bool has_texel = ray.texel_x >= 0 && ray.texel_y >= 0;
  const bool has_no_texel = ray.texel_x == -1 && ray.texel_y == -1;
  const bool costs_without_ray = hasNoRay(ray.ray_class) && ray.lookups != 0;
  return !isKnown(ray.ray_class) || costs_without_ray || (isHit(ray) ? !has_texel : !has_no_texel);
}

struct Property {
  Violates violates;
  const char* expected;
};

Property propertyOf(Metric metric) {
  switch (metric) {
    case Metric::kFinite:
      return {isNotFinite, "finite position and t_m, t_m >= 0 of a hit"};
    case Metric::kNoSelfHit:
      return {isSelfHit, "another texel than its own"};
    case Metric::kHitPointInTexel:
      return {isPointOffTexel, "px within the hit texel"};
    case Metric::kInsideImage:
      return {isOffImage, "a hit inside the image"};
    case Metric::kLookupsWithinBudget:
      return {isOverBudget, "at most lookup_budget lookups"};
    default:
      return {isInconsistent, "a class from 0 to 6, a texel exactly for HIT, no lookups without a ray"};
  }
}

std::string rayText(const RayHit& ray) {
  const int number = static_cast<int>(ray.ray_class);
  const std::string ray_class =
      isKnown(ray.ray_class) ? name(ray.ray_class) : fmt::format("class {}", number);
  return fmt::format("{} ({}, {}) px ({:.4f}, {:.4f}) t_m {:.4g} lookups {}", ray_class, ray.texel_x,
                     ray.texel_y, ray.px_x, ray.px_y, ray.t_m, ray.lookups);
}

Measurement recordProperty(Metric metric, const Answer& self) {
  if (std::string problem = problemWithRecord(self); !problem.empty()) {
    return cannotMeasure(std::move(problem));
  }
  const Property property = propertyOf(metric);
  const RayRecord* record = self.record;
  Measurement measurement;
  measurement.compared_what = "pixels";
  measurement.compared = record->rays.size();
  for (int y = 0; y < self.size.height; ++y) {
    for (int x = 0; x < self.size.width; ++x) {
      if (property.violates(record->at(x, y), self, x, y)) {
        measurement.findings.push_back({x, y, 0.0});
      }
    }
  }
  measurement.describe = [record, expected = property.expected](const Finding& finding) {
    return FindingText{rayText(record->at(finding.x, finding.y)), expected, ""};
  };
  return measurement;
}

Measurement imageFinite(const std::string& buffer, const Answer& self) {
  const auto found = self.images.find(buffer);
  if (found == self.images.end() || found->second == nullptr) {
    return cannotMeasure(fmt::format("{} left no buffer '{}'", self.device, buffer));
  }
  const Image* image = found->second;
  // +inf is background, and the motion of what was not before the previous camera.
  const bool may_be_infinite = buffer == "dist_view" || buffer == "motion";
  Measurement measurement;
  measurement.compared_what = "pixels";
  measurement.compared = image->texelCount();
  const auto is_wrong = [may_be_infinite](float value) {
    return !std::isfinite(value) && !(may_be_infinite && value > 0.0F);
  };
  const auto channels = static_cast<std::ptrdiff_t>(image->channelCount());
  for (int y = 0; y < image->size.height; ++y) {
    for (int x = 0; x < image->size.width; ++x) {
      const auto first = image->data.begin() + static_cast<std::ptrdiff_t>(image->index(x, y));
      if (std::any_of(first, first + channels, is_wrong)) {
        measurement.findings.push_back({x, y, 0.0});
      }
    }
  }
  measurement.describe = [image](const Finding& finding) {
    const auto first = image->data.begin() + static_cast<std::ptrdiff_t>(image->index(finding.x, finding.y));
    const auto last = first + static_cast<std::ptrdiff_t>(image->channelCount());
    return FindingText{fmt::format("{}", fmt::join(first, last, " ")), "finite numbers", ""};
  };
  return measurement;
}

}  // namespace

Measurement measureProperty(const Expectation& expectation, const Subject& subject) {
  Measurement measurement = expectation.buffer == "hit" ? recordProperty(expectation.metric, *subject.self)
                                                        : imageFinite(expectation.buffer, *subject.self);
  if (measurement.problem.empty()) {
    measurement.value = static_cast<double>(measurement.findings.size());
  }
  return measurement;
}

}  // namespace ssrkit
