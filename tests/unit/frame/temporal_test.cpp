// Reprojection of hits and disocclusion against closed forms.
#include <random>

#include "temporal_room.h"

namespace ssrkit {
namespace {

// techniques.md P25: the wall's texels move by -f dx / (a D), whatever the floor before them does.
TEST_P(TemporalTest, AHitIsFoundWhereItsOwnMotionSaysItWas) {
  const Step step{.right_m = 0.1, .ahead_m = 0.0};
  const Check check = [&](const std::string& shader) {
    giveRoom(step);
    giveRamp("previous_lit");
    return followsRamp(draw(shader, kRoomSize), [&](int x, int y) {
      return glm::dvec2(x + 0.5 + kScalePx * step.right_m / kWallM, 319.5 - y);
    });
  };
  holdsAndKills(check, "resolve_history.frag", {"reproject_by_receiver"});
}

TEST_P(TemporalTest, AMovingHitIsFoundWhereItWas) {
  giveRoom({}, {3.25, -1.5});
  giveRamp("previous_lit");
  EXPECT_EQ(followsRamp(draw("resolve_history.frag", kRoomSize),
                        [](int x, int y) { return glm::dvec2(x + 0.5 - 3.25, 319.5 - y + 1.5); }),
            "");
}

// A quad at 4 m before the wall at 8 m hides a strip of it that is f dx / a (1/4 - 1/8) wide once the camera
// moves.
TEST_P(TemporalTest, WhatWasHiddenBehindAQuadHasNoHistory) {
  const double right_m = 0.25;  // the quad's texels move by 16, the wall's by 8
  const auto dist = [](double column) { return column >= 96 && column < 160 ? 4.0 : 8.0; };
  const Check check = [&](const std::string& shader) {
    giveRoom({.right_m = right_m});
    const auto image = [&](double shift_px) {
      return imageOf(
          kRoomSize, [&](int x, int) { return std::array<double, 4>{dist(x - shift_px)}; }, 1);
    };
    give("dist_view", image(0.0), Format::kR32f);
    give("previous_dist_view", image(16.0), Format::kR32f);
    give("normal_view", imageOf(kRoomSize, [](int, int) { return std::array{0.0, 0.0, 1.0, 1.0}; }));
    give("motion",
         imageOf(
             kRoomSize, [&](int x, int) { return std::array<double, 4>{-kScalePx * right_m / dist(x)}; }, 2),
         Format::kRg32f);
    giveIntegers("hit_texel",
                 imageOf(
                     kRoomSize,
                     [](int x, int y) {
                       return std::array<double, 4>{1.0 * x, 1.0 * y};
                     },
                     2),
                 Format::kRg16i);
    giveRamp("previous_lit");
    const Image got = draw(shader, kRoomSize);
    for (int x = 0; x < 248; ++x) {
      const bool was_hidden = x >= 160 && x < 168;
      if (got.at(x, 77, 3) != (was_hidden ? 0.0F : 1.0F)) {
        return fmt::format("column {} has a history of {}", x, got.at(x, 77, 3));
      }
    }
    return std::string();
  };
  holdsAndKills(check, "resolve_history.frag", {"disocclusion_ignored"});
}

TEST_P(TemporalTest, WhatWasOutsideOfTheImageHasNoHistory) {
  giveRoom({.right_m = 0.5});  // 16 texels of the wall
  giveRamp("previous_lit");
  const Image got = draw("resolve_history.frag", kRoomSize);
  for (int x = 0; x < kRoomSize.width; ++x) {
    EXPECT_EQ(got.at(x, 200, 3), x < 240 ? 1.0F : 0.0F) << x;
  }
}

TEST_P(TemporalTest, WithoutAPreviousFrameThereIsNoHistory) {
  giveRoom({});
  give("previous_dist_view",
       imageOf(
           kRoomSize, [](int, int) { return std::array<double, 4>{0.0}; }, 1),
       Format::kR32f);
  giveRamp("previous_lit");
  EXPECT_EQ(difference(draw("resolve_history.frag", kRoomSize),
                       imageOf(kRoomSize, [](int, int) { return std::array<double, 4>{}; }), 0.0),
            "");
}

TEST_P(TemporalTest, AStillFrameReadsItsHistoryBitForBit) {
  giveRoom({});
  std::mt19937 random(7);
  std::uniform_real_distribution<float> colour(0.0F, 10.0F);
  Image lit(kRoomSize, {"R", "G", "B", "A"});
  std::ranges::generate(lit.data, [&] { return colour(random); });
  give("previous_lit", lit);
  const Image got = draw("resolve_history.frag", kRoomSize);
  for (int y = kFloorRow; y < kRoomSize.height; ++y) {
    for (int x = 0; x < kRoomSize.width; ++x) {
      ASSERT_EQ(got.at(x, y, 0), lit.at(x, 319 - y, 0)) << x << " " << y;
      ASSERT_EQ(got.at(x, y, 3), 1.0F);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Each, TemporalTest, testing::Values("gl-osmesa", "vk-lavapipe"), deviceTestName);

}  // namespace
}  // namespace ssrkit
