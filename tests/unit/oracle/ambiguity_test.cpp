// What the flags promise: a ray without one keeps its answer when the inputs move by a float's worth, and few
// rays have one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "analytic_scene.h"

namespace ssrkit::testing {

namespace {

Ambiguity flagAt(const OracleResult& result, int x, int y) {
  return result.ambiguity[static_cast<std::size_t>(y) * static_cast<std::size_t>(result.record.size.width) +
                          static_cast<std::size_t>(x)];
}

// Mirror floor seen from above, with slabs standing and floating over it, a tilted mirror and open
// background.
AnalyticScene clutter(Size size) {
  Camera camera = formulaCamera(size);
  const double down = 0.2;
  const glm::dvec3 up_view(0.0, std::cos(down), std::sin(down));
  std::vector<Surface> surfaces = {{.normal_view = up_view, .offset = -1.2, .is_mirror = true}};
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int slab = 0; slab < 25; ++slab) {
    const glm::dvec3 centre(3.0 * unit(random), unit(random) - 0.4, -6.0 + 3.0 * unit(random));
    const glm::dvec3 normal = glm::normalize(glm::dvec3(unit(random), 0.5 * unit(random), 1.2));
    const double radius = 0.3 + 0.3 * std::abs(unit(random));
    surfaces.push_back({.normal_view = normal,
                        .offset = glm::dot(normal, centre),
                        .is_mirror = slab % 5 == 0,
                        .contains = [=](glm::dvec3 p) { return glm::length(p - centre) < radius; }});
  }
  return render(camera, surfaces);
}

double ambiguousShare(const OracleResult& result) {
  int flagged = 0;
  int rays = 0;
  for (std::size_t i = 0; i < result.ambiguity.size(); ++i) {
    const RayClass ray_class = result.record.rays[i].ray_class;
    rays += ray_class != RayClass::kMasked && ray_class != RayClass::kBackground ? 1 : 0;
    flagged += result.ambiguity[i] != Ambiguity::kNone ? 1 : 0;
  }
  return static_cast<double>(flagged) / rays;
}

AnalyticScene perturbed(const AnalyticScene& scene, unsigned seed) {
  AnalyticScene moved = scene;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> relative(-1e-6, 1e-6);
  for (float& dist : moved.dist_view.data) {
    dist = static_cast<float>(dist * (1.0 + relative(random)));
  }
  for (int y = 0; y < scene.camera.size.height; ++y) {
    for (int x = 0; x < scene.camera.size.width; ++x) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        float& component = moved.normal_view.at(x, y, axis);
        component = static_cast<float>(component + relative(random));
      }
    }
  }
  return moved;
}

std::vector<TraceParameters> kindsOfParameters() {
  std::vector<TraceParameters> kinds(5);
  kinds[1].thickness_m = 0.3;
  kinds[2].thickness_m = 0.0;
  kinds[2].thickness_rel = 0.05;
  kinds[2].origin_bias = 0.01;
  kinds[3].max_distance_m = 2.5;
  kinds[4].lookup_budget = 23;
  kinds[4].thickness_m = 0.5;
  return kinds;
}

}  // namespace

TEST(OracleAmbiguity, AnUnflaggedRayKeepsItsTexelAndClassWhenTheInputsMoveByAMillionth) {
  const Size size{96, 72};
  for (const AnalyticScene& scene :
       {sceneM1(size), sceneM2(size), sceneM3(size), sceneM4(size), clutter(size)}) {
    for (const TraceParameters& parameters : kindsOfParameters()) {
      const OracleResult before = trace(scene, parameters);
      for (const unsigned seed : {1U, 2U, 3U, 4U}) {
        const OracleResult after = trace(perturbed(scene, seed), parameters);
        for (int y = 0; y < size.height; ++y) {
          for (int x = 0; x < size.width; ++x) {
            if (flagAt(before, x, y) == Ambiguity::kNone) {
              ASSERT_EQ(after.record.at(x, y).ray_class, before.record.at(x, y).ray_class) << x << "," << y;
              ASSERT_EQ(after.record.at(x, y).texel_x, before.record.at(x, y).texel_x) << x << "," << y;
              ASSERT_EQ(after.record.at(x, y).texel_y, before.record.at(x, y).texel_y) << x << "," << y;
            }
          }
        }
      }
    }
  }
}

TEST(OracleAmbiguity, FewRaysAreAmbiguous) {
  // Heights of 4k + 2 are left out: there every ray of m1 is an exact tie.
  for (const Size size : {Size{160, 92}, Size{320, 180}}) {
    for (const TraceParameters& parameters : kindsOfParameters()) {
      const double share = ambiguousShare(trace(clutter(size), parameters));
      EXPECT_GT(share, 0.0);
      EXPECT_LE(share, 0.015) << size.width << " T " << parameters.thickness_m;
    }
    EXPECT_LE(ambiguousShare(trace(sceneM1(size))), 0.015);
    EXPECT_LE(ambiguousShare(trace(sceneM2(size))), 0.015);
    EXPECT_LE(ambiguousShare(trace(sceneM3(size))), 0.015);
  }
  // A hit's column depends on the pixel's alone: at 160x92 one column of 55 is a tie from top to bottom.
  EXPECT_LE(ambiguousShare(trace(sceneM4({320, 180}))), 0.015);
}

TEST(OracleAmbiguity, AColumnMetWithin2e5RelativeIsADepthTie) {
  // The ray of pixel 110 is nowhere nearer than 6.779 in texel 119 (contract_test.cpp): a column that ends
  // there.
  const Size size{201, 201};
  AnalyticScene scene =
      render(formulaCamera(size), {{.normal_view = {0, 0, 1}, .offset = -10.0, .is_mirror = true}});
  TraceParameters parameters;
  parameters.thickness_m = 1.0;
  const double nearest = 200.0 / 29.5;
  scene.dist_view.at(119, 100) = static_cast<float>(nearest - 1.0 + 1e-5);
  EXPECT_EQ(flagAt(trace(scene, parameters), 110, 100), Ambiguity::kDepth);
  scene.dist_view.at(119, 100) = static_cast<float>(nearest - 1.0 - 1e-5);
  EXPECT_EQ(flagAt(trace(scene, parameters), 110, 100), Ambiguity::kDepth);
  scene.dist_view.at(119, 100) = static_cast<float>(nearest - 1.0 + 5e-3);
  EXPECT_EQ(flagAt(trace(scene, parameters), 110, 100), Ambiguity::kNone);
}

TEST(OracleImage, NamesTheTiesBesideTheRecordsOwnChannels) {
  AnalyticScene scene = sceneM4({201, 201});
  scene.dist_view.at(120, 100) = 4.000001F;
  const OracleResult result = trace(scene);
  ASSERT_EQ(flagAt(result, 100, 100), Ambiguity::kDepth);
  const Image image = toImage(result);
  const Image record = toImage(result.record);
  ASSERT_EQ(image.channelCount(), record.channelCount() + 1);
  EXPECT_EQ(image.channels.back(), "tie");
  for (std::size_t texel = 0; texel < image.texelCount(); ++texel) {
    const float* const ours = &image.data[texel * image.channelCount()];
    const float* const plain = &record.data[texel * record.channelCount()];
    ASSERT_TRUE(std::equal(plain, plain + record.channelCount(), ours)) << texel;
    ASSERT_EQ(ours[record.channelCount()], static_cast<float>(result.ambiguity[texel])) << texel;
  }
  // The numbers of docs/formats.md.
  EXPECT_EQ(image.at(100, 100, record.channelCount()), 1.0F);
  EXPECT_EQ(static_cast<int>(Ambiguity::kPosition), 2);
  EXPECT_EQ(static_cast<int>(Ambiguity::kEnd), 3);
  EXPECT_TRUE(rayRecordFromImage(image, "hit.exr").has_value());
}

TEST(OracleAmbiguity, AColumnThatALateralRayMissesByTwoFloatsIsADepthTie) {
  // The principal ray of m4 keeps dist_view 4: no step along it, however small, brings it nearer to a column.
  AnalyticScene scene = sceneM4({201, 201});
  ASSERT_EQ(flagAt(trace(scene), 100, 100), Ambiguity::kNone);
  scene.dist_view.at(120, 100) = 4.000001F;
  EXPECT_EQ(flagAt(trace(scene), 100, 100), Ambiguity::kDepth);
  scene.dist_view.at(120, 100) = 4.001F;
  EXPECT_EQ(flagAt(trace(scene), 100, 100), Ambiguity::kNone);
}

TEST(OracleAmbiguity, ACornerMattersOnlyWhenTheTexelBesideItCouldBeHit) {
  // The diagonal ray of pixel (110, 110) passes through every corner of the diagonal.
  const Size size{201, 201};
  AnalyticScene scene =
      render(formulaCamera(size), {{.normal_view = {0, 0, 1}, .offset = -10.0, .is_mirror = true}});
  EXPECT_EQ(flagAt(trace(scene), 110, 110), Ambiguity::kNone);
  scene.dist_view.at(119, 120) = 5.0F;
  EXPECT_EQ(flagAt(trace(scene), 110, 110), Ambiguity::kPosition);
  scene.dist_view.at(119, 120) = 10.0F;
  scene.dist_view.at(120, 119) = 5.0F;
  EXPECT_EQ(flagAt(trace(scene), 110, 110), Ambiguity::kPosition);
}

TEST(OracleAmbiguity, ATexelThatARayDriftsAwayFromAlongItsEdgeMatters) {
  // 4000 texels right of the centre and 1 below: a slope of 1/4000, half a texel lower at 6000 texels, in the
  // middle of texel 12050. Two texels on, the ray is 3.75e-4 below the row that it left, and ten texels
  // on 2.4e-3.
  const Size size{12101, 5};
  AnalyticScene scene =
      render(formulaCamera(size), {{.normal_view = {0, 0, 1}, .offset = -10.0, .is_mirror = true}});
  std::fill(scene.mask.data.begin(), scene.mask.data.end(), 0.0F);
  scene.mask.at(10050, 3) = 1.0F;
  EXPECT_EQ(flagAt(trace(scene), 10050, 3), Ambiguity::kNone);
  scene.dist_view.at(12052, 3) = 5.0F;
  EXPECT_EQ(flagAt(trace(scene), 10050, 3), Ambiguity::kPosition);
  scene.dist_view.at(12052, 3) = 10.0F;
  scene.dist_view.at(12060, 3) = 5.0F;
  EXPECT_EQ(flagAt(trace(scene), 10050, 3), Ambiguity::kNone);
}

TEST(OracleAmbiguity, AnOriginOnATexelsEdgeMattersOnlyWhenTheTexelBehindItCouldBeHit) {
  // A bias that brings the origin of pixel 110 from 10 to 12.501 texels right of the centre, 1e-3 inside
  // texel 113.
  AnalyticScene scene = flatScene({201, 201});
  TraceParameters parameters;
  parameters.origin_bias = 1.0 - 10.0 / 12.5002;
  EXPECT_EQ(flagAt(trace(scene, parameters), 110, 100), Ambiguity::kNone);
  scene.dist_view.at(112, 100) = 2.0F;
  const OracleResult result = trace(scene, parameters);
  EXPECT_EQ(flagAt(result, 110, 100), Ambiguity::kPosition);
  EXPECT_EQ(result.record.at(110, 100).ray_class, RayClass::kOffscreen);
}

TEST(OracleAmbiguity, ARayWhoseRangeEndsAtTheImagesEdgeIsAnEndTie) {
  // 5 texels from the centre of 41 columns: the edge, 20.5 texels away, is reached at dist 100 / 25.5.
  const Size size{41, 41};
  const AnalyticScene scene =
      render(formulaCamera(size), {{.normal_view = {0, 0, 1}, .offset = -10.0, .is_mirror = true}});
  const double tangent = 10.0 / 41.0 / 2.0;
  TraceParameters parameters;
  parameters.max_distance_m = (10.0 - 100.0 / 25.5) * std::sqrt(1.0 + tangent * tangent);
  EXPECT_EQ(flagAt(trace(scene, parameters), 25, 20), Ambiguity::kEnd);
  AnalyticScene blocked = scene;
  blocked.dist_view.at(30, 20) = 5.0F;
  EXPECT_EQ(flagAt(trace(blocked, parameters), 25, 20), Ambiguity::kNone) << "it hits before either end";
  parameters.max_distance_m -= 0.01;
  EXPECT_EQ(flagAt(trace(scene, parameters), 25, 20), Ambiguity::kNone);
}

TEST(OracleAmbiguity, ARayWhoseRangeEndsJustBeforeATexelThatItWouldHitIsAnEndTie) {
  // 10 texels from the centre, seen at 10 (20 - dist) / dist: texel 119 begins 18.5 texels from the centre.
  const auto max_distance = [](double end_px) {
    const double tangent = 20.0 / 201.0 / 2.0;
    return (10.0 - 200.0 / (end_px + 10.0)) * std::sqrt(1.0 + tangent * tangent);
  };
  const Size size{201, 201};
  AnalyticScene scene =
      render(formulaCamera(size), {{.normal_view = {0, 0, 1}, .offset = -10.0, .is_mirror = true}});
  TraceParameters parameters;
  parameters.max_distance_m = max_distance(18.4999);
  EXPECT_EQ(flagAt(trace(scene, parameters), 110, 100), Ambiguity::kNone);
  scene.dist_view.at(119, 100) = 5.0F;
  const OracleResult result = trace(scene, parameters);
  EXPECT_EQ(result.record.at(110, 100).ray_class, RayClass::kRange);
  EXPECT_EQ(flagAt(result, 110, 100), Ambiguity::kEnd);
  parameters.max_distance_m = max_distance(18.49);
  EXPECT_EQ(flagAt(trace(scene, parameters), 110, 100), Ambiguity::kNone);
}

TEST(OracleAmbiguity, AnEdgeOnNormalIsAnEndTie) {
  AnalyticScene scene = flatScene({5, 5});
  scene.normal_view.at(2, 2, 1) = 1.0F;
  scene.normal_view.at(2, 2, 2) = 0.0F;
  EXPECT_EQ(flagAt(trace(scene), 2, 2), Ambiguity::kEnd);
}

}  // namespace ssrkit::testing
