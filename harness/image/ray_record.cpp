#include "image/ray_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "base/check.h"
#include "base/text.h"

namespace ssrkit {

namespace {

enum Channel : std::size_t { kTexelX, kTexelY, kPxX, kPxY, kT, kClass, kLookups, kSteps, kChannelCount };

const std::array<std::string, kChannelCount> kChannels = {"texel.x", "texel.y", "px.x",    "px.y",
                                                          "t_m",     "class",   "lookups", "steps"};
constexpr float kMaxExactInteger = 16777216.0F;  // 2^24

bool isInteger(float value, float low, float high) {
  return value >= low && value <= high && value == std::trunc(value);
}

// What is wrong with one ray, empty when nothing is. NaN fails every comparison and so every test here.
std::string problemOf(std::span<const float> v, Size size) {
  const std::array<float, kChannelCount> high = {static_cast<float>(size.width - 1),
                                                 static_cast<float>(size.height - 1),
                                                 0,
                                                 0,
                                                 0,
                                                 kRayClassCount - 1,
                                                 kMaxExactInteger,
                                                 kMaxExactInteger};
  for (const Channel channel : {kTexelX, kTexelY, kClass, kLookups, kSteps}) {
    const float low = channel == kTexelX || channel == kTexelY ? -1.0F : 0.0F;
    if (!isInteger(v[channel], low, high[channel])) {
      return fmt::format("'{}' is {}, and must be an integer from {} to {}", kChannels[channel], v[channel],
                         low, high[channel]);
    }
  }
  for (const Channel channel : {kPxX, kPxY, kT}) {
    if (!std::isfinite(v[channel])) {
      return fmt::format("'{}' is {}, and must be finite", kChannels[channel], v[channel]);
    }
  }
  const bool is_hit = v[kClass] == static_cast<float>(RayClass::kHit);
  const bool has_texel = v[kTexelX] >= 0 && v[kTexelY] >= 0;
  const bool has_no_texel = v[kTexelX] < 0 && v[kTexelY] < 0;
  if (is_hit ? !has_texel : !has_no_texel) {
    return fmt::format("its class is {} and its hit texel is ({}, {})",
                       name(static_cast<RayClass>(v[kClass])), v[kTexelX], v[kTexelY]);
  }
  return {};
}

RayHit rayOf(std::span<const float> v) {
  return RayHit{static_cast<std::int32_t>(v[kTexelX]),
                static_cast<std::int32_t>(v[kTexelY]),
                v[kPxX],
                v[kPxY],
                v[kT],
                static_cast<RayClass>(v[kClass]),
                static_cast<std::uint32_t>(v[kLookups]),
                static_cast<std::uint32_t>(v[kSteps])};
}

Expected<std::array<std::size_t, kChannelCount>> channelOrder(const Image& image, const std::string& where) {
  std::array<std::size_t, kChannelCount> order{};
  for (std::size_t i = 0; i < kChannelCount; ++i) {
    const auto found = std::ranges::find(image.channels, kChannels[i]);
    if (found == image.channels.end()) {
      return inputError(
          "read a ray record",
          fmt::format("the channel '{}' is missing; it holds {}", kChannels[i], joinNames(image.channels)),
          where, fmt::format("a hit.exr holds {}", joinNames(kChannels)));
    }
    order[i] = static_cast<std::size_t>(found - image.channels.begin());
  }
  return order;
}

}  // namespace

const char* name(RayClass ray_class) {
  static constexpr std::array<const char*, kRayClassCount> kNames = {
      "MASKED", "BACKGROUND", "HIT", "OFFSCREEN", "RANGE", "BUDGET", "INTO_SURFACE"};
  return isKnown(ray_class) ? kNames.at(static_cast<std::size_t>(ray_class)) : "no class";
}

Image toImage(const RayRecord& record) {
  Image image(record.size, {kChannels.begin(), kChannels.end()});
  SSRKIT_CHECK_EQ(record.rays.size(), image.texelCount());
  float* out = image.data.data();
  for (const RayHit& ray : record.rays) {
    const std::array<float, kChannelCount> values = {static_cast<float>(ray.texel_x),
                                                     static_cast<float>(ray.texel_y),
                                                     ray.px_x,
                                                     ray.px_y,
                                                     ray.t_m,
                                                     static_cast<float>(ray.ray_class),
                                                     static_cast<float>(ray.lookups),
                                                     static_cast<float>(ray.steps)};
    out = std::ranges::copy(values, out).out;
  }
  return image;
}

Expected<RayRecord> rayRecordFromImage(const Image& image, const std::string& where) {
  const auto order = channelOrder(image, where);
  if (!order) {
    return tl::make_unexpected(order.error());
  }
  RayRecord record;
  record.size = image.size;
  record.rays.reserve(image.texelCount());
  std::array<float, kChannelCount> values{};
  for (std::size_t texel = 0; texel < image.texelCount(); ++texel) {
    for (std::size_t i = 0; i < kChannelCount; ++i) {
      values[i] = image.data[texel * image.channelCount() + (*order)[i]];
    }
    if (const std::string problem = problemOf(values, image.size); !problem.empty()) {
      const auto width = static_cast<std::size_t>(image.size.width);
      return inputError("read a ray record",
                        fmt::format("at texel ({}, {}) {}", texel % width, texel / width, problem), where,
                        "write it again with the tracer that made it");
    }
    record.rays.push_back(rayOf(values));
  }
  return record;
}

}  // namespace ssrkit
