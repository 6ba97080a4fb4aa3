#include "environment/octahedral.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace ssrkit {
namespace {

std::vector<glm::vec3> randomDirections(int count) {
  std::mt19937 random(11);
  std::normal_distribution<float> normal;
  std::vector<glm::vec3> directions;
  directions.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    directions.push_back(glm::normalize(glm::vec3(normal(random), normal(random), normal(random))));
  }
  return directions;
}

TEST(Octahedral, DirectionsComeBackFromTheSquare) {
  for (const glm::vec3& direction : randomDirections(1000)) {
    EXPECT_LT(glm::distance(directionFromOctahedral(octahedralFromDirection(direction)), direction), 1e-6F);
  }
}

TEST(Octahedral, UpIsTheMiddleAndDownTheCorners) {
  EXPECT_EQ(octahedralFromDirection({0, 1, 0}), glm::vec2(0.0F));
  EXPECT_EQ(glm::abs(octahedralFromDirection({0, -1, 0})), glm::vec2(1.0F));
  EXPECT_EQ(octahedralFromDirection({1, 0, 0}), glm::vec2(1, 0));
  EXPECT_EQ(octahedralFromDirection({0, 0, -1}), glm::vec2(0, -1));
}

TEST(Octahedral, SolidAnglesCoverTheSphereAndDifferByLessThanSixTimes) {
  const OctahedralMap map(66);
  double sum = 0.0;
  float least = 1.0F;
  float greatest = 0.0F;
  for (int y = 1; y <= map.inner(); ++y) {
    for (int x = 1; x <= map.inner(); ++x) {
      const float solid_angle = map.solidAngle(x, y);
      sum += static_cast<double>(solid_angle);
      least = std::min(least, solid_angle);
      greatest = std::max(greatest, solid_angle);
    }
  }
  EXPECT_NEAR(sum / (4.0 * std::numbers::pi), 1.0, 5e-4);
  EXPECT_LT(greatest / least, 5.2F);  // 3 sqrt(3) in the limit; an equirectangular map's rows reach any ratio
}

// The direction itself as colour.
OctahedralMap directionMap(int side) {
  OctahedralMap map(side);
  for (int y = 1; y <= map.inner(); ++y) {
    for (int x = 1; x <= map.inner(); ++x) {
      map.at(x, y) = directionFromOctahedral(map.square(x, y));
    }
  }
  map.wrapBorder();
  return map;
}

TEST(Octahedral, BilinearSamplesAreOffByTheBendWithinATexelOnly) {
  const OctahedralMap coarse = directionMap(34);
  const OctahedralMap fine = directionMap(66);
  float worst_coarse = 0.0F;
  float worst_fine = 0.0F;
  for (const glm::vec3& direction : randomDirections(20000)) {
    worst_coarse = std::max(worst_coarse, glm::distance(coarse.sample(direction), direction));
    worst_fine = std::max(worst_fine, glm::distance(fine.sample(direction), direction));
  }
  EXPECT_LT(worst_coarse, 0.04F);
  EXPECT_LT(worst_fine, 0.55F * worst_coarse);
}

// Two directions a hair apart, one on each side of a fold of the lower half, where the map's edges are.
TEST(Octahedral, SamplesAreContinuousAcrossEveryEdgeAndCorner) {
  const OctahedralMap map = directionMap(34);
  constexpr float kHair = 1e-5F;
  for (int i = 1; i < 2000; ++i) {
    const float along = 0.01F * static_cast<float>(i) - 10.0F;
    for (const auto& [one, other] :
         {std::pair{glm::vec3(along, -1.0F, kHair), glm::vec3(along, -1.0F, -kHair)},
          {glm::vec3(kHair, -1.0F, along), glm::vec3(-kHair, -1.0F, along)}}) {
      EXPECT_LT(glm::distance(map.sample(glm::normalize(one)), map.sample(glm::normalize(other))), 1e-4F)
          << along;
    }
  }
}

}  // namespace
}  // namespace ssrkit
