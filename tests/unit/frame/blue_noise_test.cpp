#include "frame/blue_noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace ssrkit {
namespace {

// Mean square of what a Gaussian blur of `spread` texels leaves of the mask's deviation from its mean; for
// white noise it is variance / (4 pi spread^2).
double energyAfterBlur(const std::vector<float>& mask, double spread) {
  const int reach = static_cast<int>(std::ceil(4.0 * spread));
  double sum_of_weights = 0.0;
  for (int d = -reach; d <= reach; ++d) {
    sum_of_weights += std::exp(-0.5 * d * d / (spread * spread));
  }
  double energy = 0.0;
  for (int y = 0; y < kBlueNoiseSide; ++y) {
    for (int x = 0; x < kBlueNoiseSide; ++x) {
      double blurred = 0.0;
      for (int dy = -reach; dy <= reach; ++dy) {
        for (int dx = -reach; dx <= reach; ++dx) {
          const auto row = static_cast<std::size_t>((y + dy + kBlueNoiseSide) % kBlueNoiseSide);
          const auto column = static_cast<std::size_t>((x + dx + kBlueNoiseSide) % kBlueNoiseSide);
          blurred += std::exp(-0.5 * (dx * dx + dy * dy) / (spread * spread)) *
                     (mask[row * kBlueNoiseSide + column] - 0.5);
        }
      }
      blurred /= sum_of_weights * sum_of_weights;
      energy += blurred * blurred / (kBlueNoiseSide * kBlueNoiseSide);
    }
  }
  return energy;
}

TEST(BlueNoiseTest, HoldsEveryRankOnce) {
  std::vector<float> mask = blueNoise(kBlueNoiseSide, 1);
  std::ranges::sort(mask);
  for (std::size_t rank = 0; rank < mask.size(); ++rank) {
    ASSERT_EQ(mask[rank], (static_cast<float>(rank) + 0.5F) / 4096.0F);
  }
}

TEST(BlueNoiseTest, ABlurLeavesAHundredthOfWhiteNoisesEnergyAtMost) {
  std::vector<float> mask = blueNoise(kBlueNoiseSide, 1);
  const double white = 1.0 / 12.0 / (4.0 * std::acos(-1.0) * 1.5 * 1.5);
  EXPECT_LT(energyAfterBlur(mask, 1.5), 0.01 * white);
  // The measure itself: the same ranks without their order are white.
  std::mt19937 random(3);
  std::shuffle(mask.begin(), mask.end(), random);
  EXPECT_NEAR(energyAfterBlur(mask, 1.5), white, 0.15 * white);
}

TEST(BlueNoiseTest, ItsTwoMasksDoNotKnowOfEachOther) {
  const std::vector<float> u = blueNoise(kBlueNoiseSide, 1);
  const std::vector<float> v = blueNoise(kBlueNoiseSide, 2);
  double covariance = 0.0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    covariance += (u[i] - 0.5) * (v[i] - 0.5) / static_cast<double>(u.size());
  }
  EXPECT_LT(std::abs(covariance * 12.0),
            4.0 / 64.0);  // four standard errors of a correlation over 4096 pairs
}

}  // namespace
}  // namespace ssrkit
