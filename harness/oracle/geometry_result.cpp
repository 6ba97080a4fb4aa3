#include "oracle/geometry_result.h"

#include <algorithm>
#include <array>
#include <limits>

#include "base/check.h"

namespace ssrkit {

namespace {

constexpr std::array<const char*, kTrueClassCount> kNames = {
    "NONE", "VISIBLE", "UNSAMPLED", "OCCLUDED", "BACKFACE", "OFFSCREEN_TRUE", "SKY"};

constexpr TrueRay kNoRay;

bool isRay(const TrueRay& ray) {
  return ray.true_class != TrueClass::kNone;
}

}  // namespace

const char* name(TrueClass true_class) {
  return kNames.at(static_cast<std::size_t>(true_class));
}

std::optional<TrueClass> trueClassFromName(std::string_view class_name) {
  const auto found = std::ranges::find(kNames, class_name);
  return found == kNames.end() ? std::nullopt : std::optional(static_cast<TrueClass>(found - kNames.begin()));
}

GeometryResult::GeometryResult(Size size)
    : size_(size),
      places_(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height)),
      rays_of_row_(static_cast<std::size_t>(size.height)) {
  SSRKIT_CHECK_LE(size.width, std::numeric_limits<Place>::max());
}

void GeometryResult::setRow(int y, std::span<const TrueRay> rays) {
  const auto width = static_cast<std::size_t>(size_.width);
  const auto row = static_cast<std::size_t>(y);
  SSRKIT_CHECK_EQ(rays.size(), width);
  std::vector<TrueRay>& stored = rays_of_row_.at(row);
  stored.clear();
  stored.reserve(static_cast<std::size_t>(std::ranges::count_if(rays, isRay)));
  for (std::size_t x = 0; x < width; ++x) {
    if (isRay(rays[x])) {
      stored.push_back(rays[x]);
    }
    places_[row * width + x] = isRay(rays[x]) ? static_cast<Place>(stored.size()) : Place{0};
  }
}

const TrueRay& GeometryResult::at(int x, int y) const {
  const auto row = static_cast<std::size_t>(y);
  return rayAt(places_[row * static_cast<std::size_t>(size_.width) + static_cast<std::size_t>(x)], row);
}

const TrueRay& GeometryResult::at(std::size_t pixel) const {
  return rayAt(places_[pixel], pixel / static_cast<std::size_t>(size_.width));
}

const TrueRay& GeometryResult::rayAt(Place place, std::size_t y) const {
  return place == 0 ? kNoRay : rays_of_row_[y][place - 1U];
}

}  // namespace ssrkit
