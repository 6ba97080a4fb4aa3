#include "oracle/oracle.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/check.h"
#include "base/share_out.h"
#include "base/size.h"
#include "oracle/cell_walk.h"
#include "oracle/image_ray.h"

namespace ssrkit {

namespace {

constexpr const char* kAttemptedTrace = "trace the oracle's rays";

Expected<void> checkImage(const Image& image, std::string_view image_name, Size size,
                          std::size_t least_channels, std::size_t most_channels) {
  if (image.size != size) {
    return inputError(kAttemptedTrace, fmt::format("{} is {} and the camera is {}", image_name,
                                                   sizeText(image.size), sizeText(size)));
  }
  const std::size_t channels = image.channelCount();
  if (channels < least_channels || channels > most_channels) {
    return inputError(
        kAttemptedTrace,
        fmt::format("{} has {} channels, expected {}{}", image_name, channels, least_channels,
                    least_channels == most_channels ? std::string() : fmt::format(" to {}", most_channels)));
  }
  if (image.data.size() != image.texelCount() * channels) {
    return inputError(kAttemptedTrace, fmt::format("{} holds {} numbers, expected {}", image_name,
                                                   image.data.size(), image.texelCount() * channels));
  }
  return {};
}

// Text and back: the ranges are written down once, where parameters are parsed.
Expected<void> checkParameters(const TraceParameters& parameters) {
  TraceParameters copy;
  for (const std::string& parameter : parameterNames()) {
    if (Expected<void> set = setParameter(copy, parameter, parameterText(parameters, parameter), ""); !set) {
      return set;
    }
  }
  return {};
}

void traceRow(const OracleInput& input, const PixelProjection& projection, const ColumnField& field, int y,
              OracleResult& result) {
  for (int x = 0; x < field.size.width; ++x) {
    const PixelRay pixel = pixelRay(input, projection, x, y);
    WalkResult walk;
    if (pixel.is_walked) {
      walk = walkRay(field, pixel.ray, x, y);
    } else {
      walk.hit.ray_class = pixel.early_class;
    }
    const bool reaches_end = walk.hit.ray_class != RayClass::kHit && walk.hit.ray_class != RayClass::kBudget;
    const bool is_tie = pixel.is_start_tie || (pixel.is_end_tie && reaches_end);
    if (is_tie && walk.ambiguity == Ambiguity::kNone) {
      walk.ambiguity = Ambiguity::kEnd;
    }
    const auto index = static_cast<std::size_t>(field.indexOf(x, y));
    result.record.rays[index] = walk.hit;
    result.ambiguity[index] = walk.ambiguity;
  }
}

}  // namespace

Expected<void> checkInput(const OracleInput& input) {
  SSRKIT_CHECK(input.camera != nullptr);
  SSRKIT_CHECK(input.dist_view != nullptr);
  SSRKIT_CHECK(input.normal_view != nullptr);
  const Size size = input.camera->size;
  return validate(*input.camera, kAttemptedTrace)
      .and_then([&] { return checkImage(*input.dist_view, "dist_view", size, 1, 1); })
      .and_then([&] { return checkImage(*input.normal_view, "normal_view", size, 3, 4); })
      .and_then([&] {
        return input.mask == nullptr ? Expected<void>() : checkImage(*input.mask, "mask", size, 1, 1);
      })
      .and_then([&] { return checkParameters(input.parameters); });
}

// Row by row: a second whole image would be a quarter of a gigabyte at 3840x2160.
Image toImage(const OracleResult& result) {
  const Size size = result.record.size;
  const auto width = static_cast<std::size_t>(size.width);
  SSRKIT_CHECK_EQ(result.ambiguity.size(), result.record.rays.size());
  std::vector<std::string> channels = toImage(RayRecord{}).channels;
  const std::size_t tie = channels.size();
  channels.emplace_back("tie");
  Image image(size, std::move(channels));
  float* out = image.data.data();
  for (std::size_t first = 0; first < result.record.rays.size(); first += width) {
    const auto ray = result.record.rays.begin() + static_cast<std::ptrdiff_t>(first);
    const Image row = toImage(RayRecord{{size.width, 1}, {ray, ray + size.width}});
    for (std::size_t x = 0; x < width; ++x) {
      out = std::copy_n(&row.data[x * tie], tie, out);
      *out++ = static_cast<float>(result.ambiguity[first + x]);
    }
  }
  return image;
}

Expected<OracleResult> traceOracle(const OracleInput& input, int thread_count) {
  if (Expected<void> checked = checkInput(input); !checked) {
    return tl::make_unexpected(checked.error());
  }
  const Size size = input.camera->size;
  const PixelProjection projection = pixelProjection(*input.camera);
  const ColumnField field = columnField(input);
  OracleResult result;
  result.record.size = size;
  result.record.rays.resize(input.dist_view->texelCount());
  result.ambiguity.resize(input.dist_view->texelCount());
  forEachInParallel(size.height, thread_count, [&](int y) { traceRow(input, projection, field, y, result); });
  return result;
}

std::vector<WalkCell> cellsOf(const OracleInput& input, int x, int y) {
  SSRKIT_CHECK(checkInput(input).has_value());
  SSRKIT_CHECK_LT(static_cast<unsigned>(x), static_cast<unsigned>(input.camera->size.width));
  SSRKIT_CHECK_LT(static_cast<unsigned>(y), static_cast<unsigned>(input.camera->size.height));
  const PixelRay pixel = pixelRay(input, pixelProjection(*input.camera), x, y);
  return pixel.is_walked ? walkCells(columnField(input), pixel.ray, x, y) : std::vector<WalkCell>();
}

}  // namespace ssrkit
