#include "check/leak.h"

#include <gtest/gtest.h>

#include <cmath>

#include "check/verdict.h"
#include "made_answers.h"
#include "not_finite.h"

namespace ssrkit {
namespace {

constexpr int kOwnX = 1;
constexpr int kOwnY = 8;

// One ray from pixel (1, 8) of an image of background, sideways at a constant distance of 4 m: on the image
// it runs from the texel's centre along +x and `rise` rows up for each column.
struct SidewaysRay {
  Size size{16, 16};
  Camera camera = squareCamera(size);
  Image depth{size, {"dist_view"}};
  Image normals{size, {"x", "y", "z"}};
  OracleInput input;

  explicit SidewaysRay(double rise) {
    std::ranges::fill(depth.data, kInfinity);
    depth.at(kOwnX, kOwnY) = 4.0F;
    const PixelProjection projection = pixelProjection(camera);
    const glm::dvec2 xy = (glm::dvec2(kOwnX + 0.5, kOwnY + 0.5) - projection.px_offset) / projection.px_scale;
    const glm::dvec3 view = glm::normalize(glm::dvec3(xy, -1.0));
    const glm::dvec3 wanted = glm::normalize(glm::dvec3(1.0, rise, 0.0));
    const glm::dvec3 normal = glm::normalize(wanted - view);  // mirrors `view` into `wanted`
    for (int axis = 0; axis < 3; ++axis) {
      normals.at(kOwnX, kOwnY, static_cast<std::size_t>(axis)) = static_cast<float>(normal[axis]);
    }
    input.camera = &camera;
    input.dist_view = &depth;
    input.normal_view = &normals;
    input.parameters.thickness_m = 1.0;
  }

  void put(int x, int y) { depth.at(x, y) = 3.5F; }
  [[nodiscard]] bool isLeak(const RayHit& answer) {
    LeakClassifier leaks(input);
    return leaks.isLeak(answer, kOwnX, kOwnY);
  }
};

// With rise 0.4 the ray is in row 8 up to x = 2.75, in row 7 up to 5.25, in row 6 up to 7.75. At the centres
// of the columns 2, 3, 5 it is in rows 8, 7 (y = 7.7) and 6 (y = 6.9): texels (2,7) and (5,7) are clipped
// corners.
constexpr double kRise = 0.4;

TEST(Leak, TheOracleHitsACornerThatAnEightConnectedWalkPassesBy) {
  SidewaysRay ray(kRise);
  ray.put(2, 7);
  const Expected<OracleResult> oracle = traceOracle(ray.input, 1);
  ASSERT_TRUE(oracle.has_value());
  const RayHit& truth = oracle->record.at(kOwnX, kOwnY);
  ASSERT_EQ(truth.ray_class, RayClass::kHit);
  EXPECT_EQ(truth.texel_x, 2);
  EXPECT_EQ(truth.texel_y, 7);
  EXPECT_TRUE(ray.isLeak(without(RayClass::kOffscreen)));
}

TEST(Leak, WhatRemainsMustBeTheAnswer) {
  SidewaysRay ray(kRise);
  ray.put(2, 7);
  ray.put(9, 5);  // at the centre of column 9 the ray is at y = 5.3
  EXPECT_TRUE(ray.isLeak(hitAt(9, 5)));
  EXPECT_TRUE(ray.isLeak(hitAt(10, 4)));   // within 1 px
  EXPECT_FALSE(ray.isLeak(hitAt(12, 4)));  // elsewhere
  EXPECT_FALSE(ray.isLeak(without(RayClass::kOffscreen)));
}

TEST(Leak, AMissOfAnotherClassThanTheRaysEndIsNone) {
  SidewaysRay ray(kRise);
  ray.put(2, 7);
  EXPECT_FALSE(ray.isLeak(without(RayClass::kBudget)));
  EXPECT_FALSE(ray.isLeak(without(RayClass::kRange)));
}

TEST(Leak, ATexelOnThePathIsNeverAnExcuse) {
  SidewaysRay ray(kRise);
  ray.put(3, 7);
  EXPECT_FALSE(ray.isLeak(without(RayClass::kOffscreen)));
  EXPECT_FALSE(ray.isLeak(hitAt(9, 5)));
}

TEST(Leak, SeveralCornersInARowAreOneLeak) {
  SidewaysRay ray(kRise);
  ray.put(2, 7);
  ray.put(5, 7);
  EXPECT_TRUE(ray.isLeak(without(RayClass::kOffscreen)));
  EXPECT_FALSE(ray.isLeak(hitAt(5, 7)));  // a corner too: the walk cannot have found it
}

TEST(Leak, WithoutACornerOnTheWayNothingIsExcused) {
  SidewaysRay ray(kRise);
  EXPECT_FALSE(ray.isLeak(without(RayClass::kOffscreen)));
  ray.put(3, 7);
  EXPECT_FALSE(ray.isLeak(hitAt(3, 7)));
  EXPECT_FALSE(ray.isLeak(hitAt(4, 7)));  // beside what both see: near, and no leak
}

TEST(Leak, EachQuestionIsAskedOfTheWholePicture) {
  SidewaysRay ray(kRise);
  ray.put(2, 7);
  LeakClassifier leaks(ray.input);
  for (int question = 0; question < 3; ++question) {
    EXPECT_TRUE(leaks.isLeak(without(RayClass::kOffscreen), kOwnX, kOwnY)) << question;
  }
}

TEST(Leak, TheVerdictSaysSoAndLeavesTheDepthAsItWas) {
  SidewaysRay ray(kRise);
  ray.put(2, 7);
  const Expected<OracleResult> oracle = traceOracle(ray.input, 1);
  ASSERT_TRUE(oracle.has_value());
  RayRecord record = oracle->record;
  const auto own = static_cast<std::size_t>(kOwnY) * static_cast<std::size_t>(ray.size.width) + kOwnX;
  record.rays[own] = without(RayClass::kOffscreen);
  EXPECT_EQ(compareWithOracle(record, *oracle, ray.input)[own], Verdict::kLeak);
  EXPECT_EQ(ray.depth.at(2, 7), 3.5F);
}

}  // namespace
}  // namespace ssrkit
