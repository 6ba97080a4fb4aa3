// Verdicts against the true geometry, and the metrics that count them.
#include "check/geometry_verdict.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "check/geometry_image.h"
#include "made_answers.h"

namespace ssrkit {
namespace {

constexpr Size kWallSize{16, 16};

// A wall at 3 m, rays that meet it at their own pixel's place, and a tracer that hits there.
struct Wall : Bench {
  Wall() {
    RayRecord record{kWallSize, {}};
    for (int y = 0; y < kWallSize.height; ++y) {
      for (int x = 0; x < kWallSize.width; ++x) {
        record.rays.push_back(hitAt(x, y));
        record.rays.back().t_m = 2.0F;
      }
    }
    add("hiz", std::move(record));
    setWorld(answers[0], 3.0F);
    setGeometry(answers[0]);
  }
  RayHit& ray(int x, int y) { return records[0].rays[index(x, y)]; }
  [[nodiscard]] TrueRay truth(int x, int y) const { return geometries[0].at(x, y); }
  void setTruth(int x, int y, const TrueRay& ray) {
    std::array<TrueRay, kWallSize.width> row;
    for (int i = 0; i < kWallSize.width; ++i) {
      row.at(static_cast<std::size_t>(i)) = i == x ? ray : truth(i, y);
    }
    geometries[0].setRow(y, row);
  }
  void setTrueClass(int x, int y, TrueClass true_class) {
    TrueRay ray = truth(x, y);
    ray.true_class = true_class;
    setTruth(x, y, ray);
  }
  void setDepth(int x, int y, float dist_view) { images[0].at(x, y) = dist_view; }
  [[nodiscard]] std::string verdict(int x, int y) {
    const auto verdicts = compareWithGeometry(records[0], geometries[0], inputs[0]);
    return name(verdicts[index(x, y)]);
  }
  static std::size_t index(int x, int y) {
    return static_cast<std::size_t>(y) * kWallSize.width + static_cast<std::size_t>(x);
  }
};

}  // namespace

TEST(GeometryVerdict, AHitWhereTheRayTrulyEndsIsTrue) {
  Wall wall;
  EXPECT_EQ(wall.verdict(8, 8), "TRUE_HIT");
  // Two texels beside it on the same surface is near enough, three are not.
  wall.ray(8, 8) = hitAt(10, 6);
  EXPECT_EQ(wall.verdict(8, 8), "TRUE_HIT");
  wall.ray(8, 8) = hitAt(11, 8);
  EXPECT_EQ(wall.verdict(8, 8), "FALSE_HIT");
  wall.ray(8, 8) = hitAt(8, 5);
  EXPECT_EQ(wall.verdict(8, 8), "FALSE_HIT");
}

TEST(GeometryVerdict, AHitOnAnotherSurfaceIsFalseHoweverNear) {
  Wall wall;
  wall.setDepth(8, 8, 2.0F);  // something before the wall
  EXPECT_EQ(wall.verdict(8, 8), "FALSE_HIT");
  wall.setDepth(8, 8, 4.0F);  // a hole in it
  EXPECT_EQ(wall.verdict(8, 8), "FALSE_HIT");
}

TEST(GeometryVerdict, AMissIsWrongOnlyWhereTheSurfaceIsVisible) {
  Wall wall;
  wall.ray(8, 8) = without(RayClass::kRange);
  EXPECT_EQ(wall.verdict(8, 8), "MISSED_HIT");
  for (const TrueClass unseen : {TrueClass::kUnsampled, TrueClass::kOccluded, TrueClass::kBackface,
                                 TrueClass::kOffscreen, TrueClass::kSky}) {
    wall.setTrueClass(8, 8, unseen);
    EXPECT_EQ(wall.verdict(8, 8), "TRUE_MISS") << name(unseen);
  }
}

TEST(GeometryVerdict, AHitOfWhatTheCameraCannotSeeIsFalse) {
  Wall wall;
  for (const TrueClass unseen : {TrueClass::kBackface, TrueClass::kOffscreen, TrueClass::kSky}) {
    wall.setTrueClass(8, 8, unseen);
    EXPECT_EQ(wall.verdict(8, 8), "FALSE_HIT") << name(unseen);
  }
  // At a silhouette the neighbour may show what the own texel does not.
  wall.setTrueClass(8, 8, TrueClass::kUnsampled);
  EXPECT_EQ(wall.verdict(8, 8), "TRUE_HIT");
}

TEST(GeometryVerdict, WithoutARayThereIsNone) {
  Wall wall;
  wall.setTrueClass(8, 8, TrueClass::kNone);
  EXPECT_EQ(wall.verdict(8, 8), "NONE");
}

TEST(GeometryVerdict, AHitOutsideTheImageIsFalse) {
  Wall wall;
  TrueRay at_the_edge = wall.truth(15, 15);
  at_the_edge.plane.px = {15.9, 15.9};
  wall.setTruth(15, 15, at_the_edge);
  wall.ray(15, 15) = hitAt(17, 15);
  EXPECT_EQ(wall.verdict(15, 15), "FALSE_HIT");
}

TEST(GeometryMetrics, TrueClassShareCountsTheNamedClasses) {
  Wall wall;
  for (int x = 0; x < 4; ++x) {
    wall.setTrueClass(x, 0, TrueClass::kNone);
    wall.setTrueClass(x, 1, TrueClass::kSky);
  }
  wall.setTrueClass(9, 9, TrueClass::kOccluded);
  const std::string section = "metric = \"true_class_share\"\nstages = [\"hiz\"]\n";
  const auto share = [&](const std::string& classes) {
    return wall.check(expectation(section + "true_classes = [" + classes + "]\nmin = 0\n"))
        .value.value_or(-1);
  };
  EXPECT_DOUBLE_EQ(share("\"SKY\""), 4.0 / 252.0);
  EXPECT_DOUBLE_EQ(share("\"SKY\", \"OCCLUDED\""), 5.0 / 252.0);
  EXPECT_DOUBLE_EQ(share("\"VISIBLE\""), 247.0 / 252.0);
  const CheckResult high = wall.check(expectation(section + "true_classes = [\"VISIBLE\"]\nmax = 0.9\n"));
  EXPECT_EQ(outcomeName(high), "fail");
  EXPECT_NE(high.message.find("SKY 4"), std::string::npos) << high.message;
}

TEST(GeometryMetrics, TrueVerdictShareIsOfTheNamedClasses) {
  Wall wall;
  for (int x = 0; x < 4; ++x) {
    wall.setTrueClass(x, 1, TrueClass::kSky);  // still hit: false
  }
  wall.ray(9, 9) = without(RayClass::kOffscreen);
  const auto share = [&](const std::string& verdicts, const std::string& classes) {
    return wall
        .check(expectation("metric = \"true_verdict_share\"\nmin = 0\nverdicts = [" + verdicts + "]\n" +
                           classes))
        .value.value_or(-1);
  };
  EXPECT_DOUBLE_EQ(share("\"FALSE_HIT\"", ""), 4.0 / 256.0);
  EXPECT_DOUBLE_EQ(share("\"FALSE_HIT\"", "true_classes = [\"SKY\"]"), 1.0);
  EXPECT_DOUBLE_EQ(share("\"MISSED_HIT\"", "true_classes = [\"VISIBLE\"]"), 1.0 / 252.0);
  EXPECT_DOUBLE_EQ(share("\"TRUE_HIT\", \"MISSED_HIT\"", ""), 252.0 / 256.0);
  const CheckResult failed =
      wall.check(expectation("metric = \"true_verdict_share\"\nverdicts = [\"MISSED_HIT\"]\nmax = 0\n"));
  EXPECT_EQ(outcomeName(failed), "fail");
  EXPECT_NE(failed.message.find("(9, 9)"), std::string::npos) << failed.message;
  EXPECT_NE(failed.message.find("VISIBLE (9.50, 9.50) px"), std::string::npos) << failed.message;
}

TEST(GeometryMetrics, HitErrorsAreOfVisibleRaysThatHit) {
  Wall wall;
  wall.ray(3, 4).px_x += 0.75F;
  wall.ray(5, 4).t_m = 2.5F;
  wall.ray(7, 7) = hitAt(0, 0);  // far off, but nobody can know
  wall.setTrueClass(7, 7, TrueClass::kOccluded);
  wall.ray(8, 8) = without(RayClass::kRange);
  const CheckResult position = wall.check(
      expectation("metric = \"hit_position_px\"\ntruth = \"geometry\"\nstages = [\"hiz\"]\nmax = 0.5\n"));
  EXPECT_DOUBLE_EQ(position.value.value_or(-1), 0.75);
  EXPECT_EQ(outcomeName(position), "fail");
  EXPECT_NE(position.message.find("(3, 4)"), std::string::npos) << position.message;
  const CheckResult distance = wall.check(expectation("metric = \"hit_distance_error\"\nmax = 0.25\n"));
  EXPECT_DOUBLE_EQ(distance.value.value_or(-1), 0.25);
  EXPECT_EQ(outcomeName(distance), "pass");
  const CheckResult median =
      wall.check(expectation("metric = \"hit_distance_error\"\npercentile = 50\nmax = 0\n"));
  EXPECT_EQ(outcomeName(median), "pass");
}

TEST(GeometryMetrics, WithoutTrianglesTheyAreErrors) {
  Wall wall;
  wall.answers[0].geometry = nullptr;
  for (const char* section : {"metric = \"true_class_share\"\ntrue_classes = [\"SKY\"]\nmax = 1\n",
                              "metric = \"true_verdict_share\"\nverdicts = [\"TRUE_HIT\"]\nmin = 0\n",
                              "metric = \"hit_distance_error\"\nmax = 1\n",
                              "metric = \"hit_position_px\"\ntruth = \"geometry\"\nmax = 1\n"}) {
    const CheckResult result = wall.check(expectation(section));
    EXPECT_EQ(outcomeName(result), "error") << section;
    EXPECT_NE(result.message.find("there are no triangles"), std::string::npos) << result.message;
  }
}

TEST(GeometryMetrics, DepthIsHeldAgainstWhatTheCameraTrulySees) {
  Bench bench;
  Answer& frame = bench.add("", RayRecord{kWallSize, {}});
  bench.setImage(frame, "dist_view", 3.0F);
  Image& truth = bench.images.emplace_back(kWallSize, std::vector<std::string>{"v"});
  std::ranges::fill(truth.data, 3.0F);
  truth.at(2, 3) = std::numeric_limits<float>::infinity();
  truth.at(4, 5) = 2.5F;
  const std::string section = "buffer = \"dist_view\"\ntruth = \"geometry\"\n";
  const Expectation flips = expectation("metric = \"coverage_flips\"\n" + section);
  EXPECT_EQ(outcomeName(bench.check(flips)), "error");
  frame.true_dist_view = &truth;
  EXPECT_DOUBLE_EQ(bench.check(flips).value.value_or(-1), 1.0);
  const Expectation error =
      expectation("metric = \"relative_error\"\npercentile = 99.6\nmax = 0.2\n" + section);
  EXPECT_NEAR(bench.check(error).value.value_or(-1), 0.2, 1e-7);
}

TEST(GeometryImage, HoldsWhatAReaderNeeds) {
  Wall wall;
  wall.setTruth(1, 0, {.true_class = TrueClass::kOffscreen, .t_m = 2.0, .dist_view = -2.0});
  wall.setTruth(2, 0, {.true_class = TrueClass::kSky});
  const auto verdicts = compareWithGeometry(wall.records[0], wall.geometries[0], wall.inputs[0]);
  const Image image = toImage(wall.geometries[0], verdicts);
  EXPECT_EQ(image.channels,
            (std::vector<std::string>{"class", "px.x", "px.y", "t_m", "dist_view", "verdict"}));
  const auto texel = [&](int x) {
    const auto first = image.data.begin() + static_cast<std::ptrdiff_t>(image.index(x, 0));
    return std::vector<float>(first, first + 6);
  };
  EXPECT_EQ(texel(0), (std::vector<float>{1, 0.5F, 0.5F, 2, 3, 1}));
  EXPECT_EQ(texel(1), (std::vector<float>{5, -1, -1, 2, -2, 2}));
  EXPECT_EQ(texel(2), (std::vector<float>{6, -1, -1, -1, 0, 2}));
}

}  // namespace ssrkit
