// Accumulation over frames against closed forms.
#include <random>

#include "temporal_room.h"

namespace ssrkit {
namespace {

// The history is read at `position_px`: it weighs 3/4 after three frames, and the neighbours of this frame's
// chequered reflection, 0 and 1, do not clamp it.
class AccumulateTest : public TemporalTest {
 protected:
  std::string readsHistoryAt(const std::string& shader,
                             const std::function<glm::dvec2(int x, int y)>& position_px) {
    giveRamp("previous_accumulated");
    give("previous_history_length",
         imageOf(
             kRoomSize, [](int, int) { return std::array<double, 4>{3.0}; }, 1),
         Format::kR32f);
    const auto chequer = [](int x, int y) { return static_cast<double>((x + y) % 2); };
    give("reflection", imageOf(kRoomSize, [&](int x, int y) {
           return std::array{chequer(x, y), chequer(x, y), 0.0, 1.0};
         }));
    Image history = drawAll(shader, kRoomSize, {Format::kRgba32f, Format::kR32f}).front();
    for (int y = 0; y < kRoomSize.height; ++y) {
      for (int x = 0; x < kRoomSize.width; ++x) {
        for (const std::size_t channel : {0U, 1U}) {
          float& value = history.at(x, y, channel);
          value = (4.0F * value - static_cast<float>(chequer(x, y))) / 3.0F;
        }
      }
    }
    return followsRamp(history, position_px);
  }
};

// The image of the wall in the floor lies as deep as the wall, so it moves like the wall and not like the
// floor.
TEST_P(AccumulateTest, AReflectionMovesLikeTheImageBehindTheMirror) {
  const Step step{.right_m = 0.1, .ahead_m = 0.3};
  const Check check = [&](const std::string& shader) {
    giveRoom(step);
    return readsHistoryAt(shader, [&](int x, int y) {
      return roomPxOf(previousView(roomViewOf({x + 0.5, y + 0.5}, kWallM), step));
    });
  };
  holdsAndKills(check, "accumulate.frag", {"accumulate_by_receiver"});
}

TEST_P(AccumulateTest, TheImageOfAMovingThingMovesUpsideDown) {
  giveRoom({}, {3.25, -1.5});
  EXPECT_EQ(readsHistoryAt("accumulate.frag",
                           [](int x, int y) { return glm::dvec2(x + 0.5 - 3.25, y + 0.5 - 1.5); }),
            "");
}

TEST_P(AccumulateTest, AStillPictureIsAFixedPoint) {
  giveRoom({});
  std::mt19937 random(11);
  std::uniform_real_distribution<float> colour(0.0F, 10.0F);
  Image reflection(kRoomSize, {"R", "G", "B", "A"});
  std::ranges::generate(reflection.data, [&] { return colour(random); });
  for (std::size_t i = 3; i < reflection.data.size(); i += 4) {
    reflection.data[i] = 1.0F;
  }
  give("reflection", reflection);
  give("previous_accumulated", reflection);
  give("previous_history_length",
       imageOf(
           kRoomSize, [](int, int) { return std::array<double, 4>{4.0}; }, 1),
       Format::kR32f);
  const std::vector<Image> got = drawAll("accumulate.frag", kRoomSize, {Format::kRgba32f, Format::kR32f});
  EXPECT_EQ(got[0].data, reflection.data);
  EXPECT_EQ(got[1].at(100, 200), 5.0F);
  EXPECT_EQ(got[1].at(100, 20), 0.0F);
}

// The floor's texels lie on one plane to within rounding, so the narrowest tolerance keeps them all.
TEST_P(AccumulateTest, APlaneKeepsItsHistoryUnderTheNarrowestTolerance) {
  giveRoom({});
  values_.set("disocclusion_rel", 1e-5);
  const auto constant = [](double value) {
    return imageOf(kRoomSize, [=](int, int) { return std::array{value, value, value, 1.0}; });
  };
  give("reflection", constant(0.5));
  give("previous_accumulated", constant(0.5));
  give("previous_history_length",
       imageOf(
           kRoomSize, [](int, int) { return std::array<double, 4>{4.0}; }, 1),
       Format::kR32f);
  const Image length = drawAll("accumulate.frag", kRoomSize, {Format::kRgba32f, Format::kR32f})[1];
  for (int y = kFloorRow; y < kRoomSize.height; ++y) {
    for (int x = 0; x < kRoomSize.width; ++x) {
      ASSERT_EQ(length.at(x, y), 5.0F) << x << " " << y;
    }
  }
}

TEST_P(AccumulateTest, AGhostIsClampedToTheNeighbours) {
  const Check check = [&](const std::string& shader) {
    giveRoom({});
    give("reflection", imageOf(kRoomSize, [](int, int) { return std::array{0.5, 0.5, 0.5, 1.0}; }));
    give("previous_accumulated", imageOf(kRoomSize, [](int, int) { return std::array{5.0, 0.0, 0.5, 1.0}; }));
    give("previous_history_length",
         imageOf(
             kRoomSize, [](int, int) { return std::array<double, 4>{9.0}; }, 1),
         Format::kR32f);
    return difference(drawAll(shader, kRoomSize, {Format::kRgba32f, Format::kR32f}).front(),
                      imageOf(kRoomSize,
                              [](int, int) {
                                return std::array{0.5, 0.5, 0.5, 1.0};
                              }),
                      0.0);
  };
  holdsAndKills(check, "accumulate.frag", {"history_unclamped"});
}

INSTANTIATE_TEST_SUITE_P(Each, AccumulateTest, testing::Values("gl-osmesa", "vk-lavapipe"), deviceTestName);

}  // namespace
}  // namespace ssrkit
