// What stochastic reuse is told of each pixel's ray, against closed forms in the room of m1.
#include "temporal_room.h"

namespace ssrkit {
namespace {

class RayEndsTest : public TemporalTest {
 protected:
  [[nodiscard]] std::vector<Image> ends() {
    giveRoom({});
    values_.set("origin_bias", 0.0);
    values_.set("up_view", glm::dvec3(0, 1, 0));
    values_.set("sky_horizon", glm::dvec3(0.25));
    values_.set("sky_zenith", glm::dvec3(0.25));
    give("microfacet_normal", imageOf(kRoomSize, [](int, int y) {
           return isFloorRow(y) ? std::array{0.0, 1.0, 0.0, 1.0} : std::array{0.0, 0.0, 1.0, 1.0};
         }));
    giveRamp("lit");
    // The right half of the floor meets nothing.
    giveIntegers("hit_texel",
                 imageOf(
                     kRoomSize,
                     [](int x, int y) {
                       return x < 128 ? hitOf(x, y) : std::array<double, 4>{-1.0, -1.0};
                     },
                     2),
                 Format::kRg16i);
    return drawAll("ray_ends.frag", kRoomSize, {Format::kRgba32f, Format::kRgba32f, Format::kRg32f});
  }
};

// From d (rx, ry, -1) along (rx, -ry, -1) to the wall at 8 m: (8 rx, (2 d - 8) ry, -8).
TEST_P(RayEndsTest, ARayEndsOnTheWallThatItHits) {
  const std::vector<Image> got = ends();
  for (int y = kFloorRow; y < kRoomSize.height; ++y) {
    for (int x = 0; x < 128; ++x) {
      const double dist = roomDistAt(y);
      const glm::dvec3 pinhole = roomViewOf({x + 0.5, y + 0.5}, 1.0);
      const glm::dvec3 end(kWallM * pinhole.x, (2.0 * dist - kWallM) * pinhole.y, -kWallM);
      for (int axis = 0; axis < 3; ++axis) {
        ASSERT_NEAR(got[0].at(x, y, static_cast<std::size_t>(axis)), end[axis], 2e-5) << x << " " << y;
      }
      ASSERT_NEAR(got[0].at(x, y, 3), glm::length(end - dist * pinhole), 2e-5) << x << " " << y;
      ASSERT_EQ(got[1].at(x, y, 1), (320.0F - static_cast<float>(y) - 0.5F) / 256.0F) << x << " " << y;
    }
  }
}

TEST_P(RayEndsTest, ARayThatMeetsNothingKeepsItsDirectionAndTheSky) {
  const std::vector<Image> got = ends();
  for (int y = kFloorRow; y < kRoomSize.height; ++y) {
    for (int x = 128; x < kRoomSize.width; ++x) {
      const glm::dvec3 pinhole = roomViewOf({x + 0.5, y + 0.5}, 1.0);
      const glm::dvec3 direction = glm::normalize(glm::dvec3(pinhole.x, -pinhole.y, -1.0));
      for (int axis = 0; axis < 3; ++axis) {
        ASSERT_NEAR(got[0].at(x, y, static_cast<std::size_t>(axis)), direction[axis], 1e-6) << x << " " << y;
      }
      ASSERT_EQ(got[0].at(x, y, 3), 0.0F);
      ASSERT_NEAR(got[1].at(x, y, 0), 0.25F, 1e-6);
    }
  }
}

TEST_P(RayEndsTest, WhatReflectsNothingHasNoRay) {
  const std::vector<Image> got = ends();
  for (int y = 0; y < kFloorRow; ++y) {
    for (int x = 0; x < kRoomSize.width; ++x) {
      ASSERT_EQ(got[0].at(x, y, 3), -1.0F) << x << " " << y;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Each, RayEndsTest, testing::Values("gl-osmesa", "vk-lavapipe"), deviceTestName);

}  // namespace
}  // namespace ssrkit
