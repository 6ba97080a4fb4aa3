#include "frame/blue_noise.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace ssrkit {

namespace {

constexpr double kSpread =
    1.9;                   // of the Gaussian in texels: Ulichney's 1.5 leaves more of the low frequencies
constexpr int kReach = 9;  // beyond it a point's density is below 2e-5
constexpr float kNever = std::numeric_limits<float>::infinity();

// Points on a torus, and the density of points about each texel.
class PointPattern {
 public:
  explicit PointPattern(int side) : side_(side), is_set_(count()), density_(count()) {}

  [[nodiscard]] std::size_t count() const {
    return static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_);
  }
  [[nodiscard]] bool isSet(std::size_t texel) const { return is_set_[texel] != 0; }

  void toggle(std::size_t texel) {
    is_set_[texel] ^= 1;
    const int x = static_cast<int>(texel) % side_;
    const int y = static_cast<int>(texel) / side_;
    const double sign = isSet(texel) ? 1.0 : -1.0;
    for (int dy = -kReach; dy <= kReach; ++dy) {
      for (int dx = -kReach; dx <= kReach; ++dx) {
        const auto row = static_cast<std::size_t>((y + dy + side_) % side_);
        const auto column = static_cast<std::size_t>((x + dx + side_) % side_);
        density_[row * static_cast<std::size_t>(side_) + column] +=
            static_cast<float>(sign * std::exp(-0.5 * (dx * dx + dy * dy) / (kSpread * kSpread)));
      }
    }
  }

  // The texel without a point where they are thinnest, and the one with a point where they are densest.
  [[nodiscard]] std::size_t largestVoid() const { return extreme(0, 1.0F); }
  [[nodiscard]] std::size_t tightestCluster() const { return extreme(1, -1.0F); }

 private:
  [[nodiscard]] std::size_t extreme(std::uint8_t state, float sign) const {
    std::size_t best = 0;
    float least = kNever;
    for (std::size_t texel = 0; texel < density_.size(); ++texel) {
      const float value = is_set_[texel] == state ? sign * density_[texel] : kNever;
      if (value < least) {
        least = value;
        best = texel;
      }
    }
    return best;
  }

  int side_;
  std::vector<std::uint8_t> is_set_;
  std::vector<float> density_;
};

// A tenth of the texels, moved from the tightest cluster to the largest void until that moves nothing.
PointPattern evenPattern(int side, unsigned seed) {
  PointPattern pattern(side);
  std::mt19937 random(seed);
  for (std::size_t placed = 0; placed < pattern.count() / 10;) {
    const std::size_t texel = random() % pattern.count();
    if (!pattern.isSet(texel)) {
      pattern.toggle(texel);
      ++placed;
    }
  }
  while (true) {
    const std::size_t cluster = pattern.tightestCluster();
    pattern.toggle(cluster);
    const std::size_t hole = pattern.largestVoid();
    pattern.toggle(hole);
    if (hole == cluster) {
      return pattern;
    }
  }
}

}  // namespace

std::vector<float> blueNoise(int side, unsigned seed) {
  const PointPattern start = evenPattern(side, seed);
  const std::size_t count = start.count();
  std::vector<float> mask(count);
  const auto setRank = [&](std::size_t texel, std::size_t rank) {
    mask[texel] = (static_cast<float>(rank) + 0.5F) / static_cast<float>(count);
  };
  // The pattern's own points are ranked by taking them away, all others by adding them.
  PointPattern thinned = start;
  for (std::size_t rank = count / 10; rank-- > 0;) {
    const std::size_t cluster = thinned.tightestCluster();
    thinned.toggle(cluster);
    setRank(cluster, rank);
  }
  PointPattern filled = start;
  for (std::size_t rank = count / 10; rank < count; ++rank) {
    const std::size_t hole = filled.largestVoid();
    filled.toggle(hole);
    setRank(hole, rank);
  }
  return mask;
}

Expected<void> uploadBlueNoise(Device& device, FrameImages& images) {
  static const std::vector<float> texels = [] {
    const std::vector<float> u = blueNoise(kBlueNoiseSide, 1);
    const std::vector<float> v = blueNoise(kBlueNoiseSide, 2);
    std::vector<float> both;
    for (std::size_t i = 0; i < u.size(); ++i) {
      both.insert(both.end(), {u[i], v[i]});
    }
    return both;
  }();
  const auto image = images.getSized({.name = "blue_noise",
                                      .format = Format::kRg32f,
                                      .size = {kBlueNoiseSide, kBlueNoiseSide},
                                      .mip_count = 1});
  return image ? device.upload(**image, 0, std::as_bytes(std::span(texels)))
               : tl::make_unexpected(image.error());
}

}  // namespace ssrkit
