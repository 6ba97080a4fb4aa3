#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "gltf_test_file.h"
#include "scene/motion.h"

namespace ssrkit::test {
namespace {

using nlohmann::json;

const float kHalfRoot = std::sqrt(0.5F);

// The triangle's second corner, (1, 0, 0) in the mesh, at a time.
glm::vec3 cornerAt(Scene& scene, double time_s) {
  const auto posed = poseScene(scene, time_s, time_s);
  EXPECT_TRUE(posed) << sentence(posed.error());
  return scene.vertices[1].p_world;
}

Scene loaded(const json& root) {
  auto scene = loadFile(root);
  EXPECT_TRUE(scene) << sentence(scene.error());
  return scene ? *std::move(scene) : Scene{};
}

void expectNear(const glm::vec3& got, const glm::dvec3& want) {
  EXPECT_NEAR(glm::distance(glm::dvec3(got), want), 0.0, 2e-7)
      << got.x << " " << got.y << " " << got.z << " for " << want.x << " " << want.y << " " << want.z;
}

TEST(GltfAnimation, ALinearTranslationMovesEvenlyAndStandsStillOutsideItsKeys) {
  json root = triangleFile();
  animate(root, 0, "translation", "LINEAR", {1, 3}, {0, 0, 0, 4, -2, 8});
  Scene scene = loaded(root);
  expectNear(cornerAt(scene, 0.0), {1, 0, 0});
  expectNear(cornerAt(scene, 1.5), {2, -0.5, 2});
  expectNear(cornerAt(scene, 3.0), {5, -2, 8});
  expectNear(cornerAt(scene, 99.0), {5, -2, 8});
}

TEST(GltfAnimation, AStepHoldsItsValueUntilTheNextKey) {
  json root = triangleFile();
  animate(root, 0, "scale", "STEP", {0, 1}, {2, 1, 1, 5, 1, 1});
  Scene scene = loaded(root);
  expectNear(cornerAt(scene, 0.999), {2, 0, 0});
  expectNear(cornerAt(scene, 1.0), {5, 0, 0});
}

TEST(GltfAnimation, ALinearRotationTurnsEvenlyAlongTheShorterWay) {
  json root = triangleFile();
  // From 0 to 90 degrees about z; the second quaternion is the negative one, of the same rotation and not
  // unit.
  animate(root, 0, "rotation", "LINEAR", {0, 1}, {0, 0, 0, 1, 0, 0, -3 * kHalfRoot, -3 * kHalfRoot});
  Scene scene = loaded(root);
  for (const double share : {0.0, 0.2, 0.5, 0.9, 1.0}) {
    const double angle = share * glm::half_pi<double>();
    expectNear(cornerAt(scene, share), {std::cos(angle), std::sin(angle), 0});
  }
}

TEST(GltfAnimation, ACubicSplineIsHermitesWithTangentsPerSecond) {
  json root = triangleFile();
  // p(0) = 1, p'(0) = 3, p(2) = 5, p'(2) = -1 over two seconds; at s = 1/4 by the Hermite basis:
  // 1 * 27/32 + 2 * 3 * 9/64 + 5 * 5/32 + 2 * -1 * -3/64 = 2.5625.
  animate(root, 0, "translation", "CUBICSPLINE", {0, 2},
          {9, 9, 9, 1, 0, 0, 3, 0, 0, /**/ -1, 0, 0, 5, 0, 0, 9, 9, 9});
  Scene scene = loaded(root);
  expectNear(cornerAt(scene, 0.0), {2, 0, 0});
  expectNear(cornerAt(scene, 0.5), {3.5625, 0, 0});
  expectNear(cornerAt(scene, 2.0), {6, 0, 0});
}

TEST(GltfAnimation, ACubicSplineOfRotationsStaysARotation) {
  json root = triangleFile();
  animate(root, 0, "rotation", "CUBICSPLINE", {0, 1},
          {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, /**/ 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0});
  Scene scene = loaded(root);
  // Half way the spline is (0, 0, 1/2, 1/2): 90 degrees once it is normalised.
  expectNear(cornerAt(scene, 0.5), {0, 1, 0});
}

TEST(GltfAnimation, AChildMovesWithItsParentAndKeepsItsOwnTransform) {
  json root = triangleFile();
  root["nodes"] = {{{"children", {1}}}, {{"mesh", 0}, {"translation", {2, 0, 0}}}, {{"mesh", 0}}};
  root["scenes"][0]["nodes"] = {0, 2};
  animate(root, 0, "rotation", "LINEAR", {0, 1}, {0, 0, 0, 1, 0, 0, kHalfRoot, kHalfRoot});
  Scene scene = loaded(root);
  const glm::vec3 still = scene.vertices[4].p_world;
  expectNear(cornerAt(scene, 1.0), {0, 3, 0});
  EXPECT_EQ(scene.vertices[4].p_world, still);
  EXPECT_EQ(scene.motion->meshes.size(), 1U);
}

TEST(GltfAnimation, ThePreviousPlaceIsOfTheSameCorner) {
  json root = triangleFile();
  // At 1 s the node mirrors, so its triangles' corners change places.
  animate(root, 0, "scale", "STEP", {0, 1}, {1, 1, 1, -2, 1, 1});
  Scene scene = loaded(root);
  ASSERT_TRUE(poseScene(scene, 1.0, 0.0));
  expectNear(scene.vertices[2].p_world, {-2, 0, 0});
  expectNear(scene.vertices[2].p_previous_world, {1, 0, 0});
  expectNear(scene.vertices[2].normal_world, {0, 0, 1});
}

TEST(GltfAnimation, WhatHasNoAreaAtFirstGrowsLater) {
  json root = triangleFile();
  animate(root, 0, "scale", "LINEAR", {0, 1}, {0, 0, 0, 1, 1, 1});
  root["scenes"][0]["nodes"] = {0};
  Scene scene = loaded(root);
  ASSERT_EQ(scene.vertices.size(), 3U);
  expectNear(cornerAt(scene, 0.5), {0.5, 0, 0});
  expectNear(scene.vertices[1].face_normal_world, {0, 0, 1});
}

TEST(GltfAnimation, APoseIsTheSameWhateverWasPosedBefore) {
  json root = triangleFile();
  animate(root, 0, "rotation", "LINEAR", {0, 1}, {0, 0, 0, 1, 0.2F, 0.3F, 0.1F, 0.9F});
  Scene scene = loaded(root);
  const glm::vec3 first = cornerAt(scene, 0.3);
  static_cast<void>(cornerAt(scene, 0.9));
  EXPECT_EQ(cornerAt(scene, 0.3), first);
}

TEST(GltfAnimation, CamerasAndLightsMoveWithTheirNodes) {
  json root = triangleFile();
  root["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.01}}}}};
  root["extensionsUsed"] = {"KHR_lights_punctual"};
  root["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "directional"}}, {{"type", "point"}}};
  root["nodes"].push_back({{"camera", 0}});
  for (const int light : {0, 1}) {
    root["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", light}}}}}});
  }
  root["scenes"][0]["nodes"] = {0, 1, 2, 3};
  animate(root, 1, "translation", "LINEAR", {0, 1}, {0, 0, 4, 0, 0, 8});
  animate(root, 2, "rotation", "LINEAR", {0, 1}, {0, 0, 0, 1, kHalfRoot, 0, 0, kHalfRoot});
  animate(root, 3, "translation", "LINEAR", {0, 1}, {0, 0, 0, 6, 0, 0});
  Scene scene = loaded(root);
  const double far_at_start = scene.cameras[0].far_m;
  ASSERT_TRUE(poseScene(scene, 1.0, 0.5));
  EXPECT_EQ(scene.cameras[0].view_from_world[3], glm::dvec4(0, 0, -8, 1));
  EXPECT_EQ(scene.cameras[0].previous_view_from_world[3], glm::dvec4(0, 0, -6, 1));
  EXPECT_GT(scene.cameras[0].far_m, far_at_start);
  EXPECT_NEAR(glm::distance(scene.directional_lights[0].direction_world, glm::dvec3(0, 1, 0)), 0.0, 1e-7);
  EXPECT_EQ(scene.point_lights[0].p_world, glm::dvec3(6, 0, 0));
}

TEST(GltfAnimation, OfTwoAnimationsOfOnePropertyTheFirstPlays) {
  json root = triangleFile();
  animate(root, 0, "translation", "STEP", {0}, {1, 0, 0});
  animate(root, 0, "translation", "STEP", {0}, {7, 0, 0});
  animate(root, 0, "scale", "STEP", {0}, {3, 1, 1});
  Scene scene = loaded(root);
  expectNear(cornerAt(scene, 0.0), {4, 0, 0});
  EXPECT_TRUE(hasNote(scene, "1 animation channel left out: an earlier animation"));
}

TEST(GltfAnimation, MorphWeightsAreNoted) {
  json root = triangleFile();
  animate(root, 0, "translation", "STEP", {0}, {1, 0, 0});
  root["animations"][0]["channels"][0]["target"]["path"] = "weights";
  const Scene scene = loaded(root);
  EXPECT_TRUE(hasNote(scene, "1 animation channel of morph weights, or of no node, left out"));
  EXPECT_EQ(scene.motion, nullptr);
}

TEST(GltfAnimation, APlaceOutsideSinglePrecisionIsRefusedWhenItIsReached) {
  json root = triangleFile();
  root["nodes"][0]["name"] = "rocket";
  root["nodes"].push_back({{"children", {0}}, {"scale", {1e30, 1, 1}}});
  root["scenes"][0]["nodes"] = {1};
  animate(root, 0, "translation", "LINEAR", {0, 1}, {0, 0, 0, 1e30F, 0, 0});
  Scene scene = loaded(root);
  const auto posed = poseScene(scene, 1.0, 0.0);
  ASSERT_FALSE(posed);
  EXPECT_NE(sentence(posed.error()).find("nodes[0] 'rocket'"), std::string::npos) << sentence(posed.error());
}

}  // namespace
}  // namespace ssrkit::test
