#include "report/sheet_pictures.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/check.h"
#include "image/colour_map.h"
#include "report/verdict_colours.h"

namespace ssrkit {

namespace {

constexpr int kMaxCellSide = 320;
constexpr int kMaxGrow = 4;

int boxesAlong(int texels, int box) {
  return (texels + box - 1) / box;
}

// Calls visit(dot, texel) for every texel of the image, both as indices; texels of one dot come in any order.
template <class Visit>
void forEachTexel(Size size, const CellScale& scale, const Visit& visit) {
  std::size_t texel = 0;
  for (int y = 0; y < size.height; ++y) {
    const auto row =
        static_cast<std::size_t>(y / scale.shrink) * static_cast<std::size_t>(scale.picture.width);
    int left_in_box = scale.shrink;
    std::size_t dot = row;
    for (int x = 0; x < size.width; ++x) {
      visit(dot, texel++);
      if (--left_in_box == 0) {
        left_in_box = scale.shrink;
        ++dot;
      }
    }
  }
}

void setDot(ByteImage& picture, std::size_t dot, Rgb8 colour) {
  std::ranges::copy(colour, picture.data.begin() + static_cast<std::ptrdiff_t>(dot * 3));
}

Rgb8 dotOf(const ByteImage& picture, std::size_t dot) {
  return {picture.data[dot * 3], picture.data[dot * 3 + 1], picture.data[dot * 3 + 2]};
}

}  // namespace

CellScale cellScaleFor(Size size) {
  const int longer = std::max({size.width, size.height, 1});
  CellScale scale;
  scale.shrink = boxesAlong(longer, kMaxCellSide);
  scale.grow = scale.shrink == 1 ? std::clamp(kMaxCellSide / longer, 1, kMaxGrow) : 1;
  scale.picture = {boxesAlong(size.width, scale.shrink), boxesAlong(size.height, scale.shrink)};
  return scale;
}

ByteImage lightPicture(const Image& linear, const CellScale& scale, double exposure) {
  const std::size_t channels = linear.channelCount();
  SSRKIT_CHECK(channels == 1 || channels >= 3);
  const std::size_t kept = channels == 1 ? 1 : 3;
  Image shrunk(scale.picture, std::vector<std::string>(kept));
  std::vector<float> texel_counts(shrunk.texelCount());
  forEachTexel(linear.size, scale, [&](std::size_t dot, std::size_t texel) {
    for (std::size_t i = 0; i < kept; ++i) {
      shrunk.data[dot * kept + i] += linear.data[texel * channels + i];
    }
    texel_counts[dot] += 1.0F;
  });
  for (std::size_t dot = 0; dot < texel_counts.size(); ++dot) {
    for (std::size_t i = 0; i < kept; ++i) {
      shrunk.data[dot * kept + i] /= texel_counts[dot];
    }
  }
  return toneMap(shrunk, exposure);
}

ByteImage dimmed(const ByteImage& light) {
  constexpr double kDarkest = 20.0;
  constexpr double kRange = 0.35;
  ByteImage dark = light;
  for (std::size_t dot = 0; dot < light.texelCount(); ++dot) {
    const Rgb8 colour = dotOf(light, dot);
    const double grey = 0.299 * colour[0] + 0.587 * colour[1] + 0.114 * colour[2];
    const auto level = static_cast<std::uint8_t>(kDarkest + kRange * grey);
    setDot(dark, dot, {level, level, level});
  }
  return dark;
}

ByteImage verdictPicture(std::span<const Verdict> verdicts, Size size, const CellScale& scale,
                         const ByteImage& backdrop) {
  std::array<std::uint8_t, kVerdictCount> harmlessness{};
  for (std::size_t i = 0; i < kWorstFirst.size(); ++i) {
    harmlessness.at(static_cast<std::size_t>(kWorstFirst[i])) = static_cast<std::uint8_t>(i);
  }
  std::vector<std::uint8_t> worst(backdrop.texelCount(), kVerdictCount - 1);
  forEachTexel(size, scale, [&](std::size_t dot, std::size_t texel) {
    worst[dot] = std::min(worst[dot], harmlessness.at(static_cast<std::size_t>(verdicts[texel])));
  });
  constexpr double kSameOpacity = 0.5;
  ByteImage picture = backdrop;
  for (std::size_t dot = 0; dot < worst.size(); ++dot) {
    const Verdict verdict = kWorstFirst.at(worst[dot]);
    if (verdict != Verdict::kNone) {
      const double opacity = verdict == Verdict::kSame ? kSameOpacity : 1.0;
      setDot(picture, dot, blend(dotOf(backdrop, dot), colourOf(verdict), opacity));
    }
  }
  return picture;
}

ByteImage heatPicture(const RayRecord& record, const CellScale& scale, const HeatScale& heat,
                      const ByteImage& backdrop) {
  std::vector<double> lookups(backdrop.texelCount());
  std::vector<double> ray_counts(backdrop.texelCount());
  forEachTexel(record.size, scale, [&](std::size_t dot, std::size_t texel) {
    const RayHit& ray = record.rays[texel];
    if (!hasNoRay(ray.ray_class)) {
      lookups[dot] += ray.lookups;
      ray_counts[dot] += 1.0;
    }
  });
  ByteImage picture = backdrop;
  for (std::size_t dot = 0; dot < lookups.size(); ++dot) {
    if (ray_counts[dot] > 0.0) {
      setDot(picture, dot, heat.colourOf(lookups[dot] / ray_counts[dot]));
    }
  }
  return picture;
}

}  // namespace ssrkit
