#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "gltf_test_file.h"

namespace ssrkit::test {
namespace {

using nlohmann::json;

json withLight(const json& light, const json& node = json::object()) {
  json root = triangleFile();
  root["extensionsUsed"] = {"KHR_lights_punctual"};
  root["extensions"]["KHR_lights_punctual"]["lights"] = {light};
  json light_node = node;
  light_node["extensions"]["KHR_lights_punctual"]["light"] = 0;
  root["nodes"].push_back(light_node);
  root["scenes"][0]["nodes"].push_back(1);
  return root;
}

TEST(GltfLights, ADirectionalLightTravelsAlongItsNodesMinusZ) {
  // 90 degrees about x: -z becomes +y.
  const auto scene = loadFile(withLight({{"type", "directional"}, {"intensity", 2}, {"color", {1, 0.5, 0}}},
                                        {{"rotation", {0.7071067811865476, 0, 0, 0.7071067811865476}}}));
  ASSERT_TRUE(scene) << sentence(scene.error());
  ASSERT_EQ(scene->directional_lights.size(), 1U);
  EXPECT_NEAR(glm::distance(scene->directional_lights[0].direction_world, glm::dvec3(0, 1, 0)), 0.0, 1e-12);
  EXPECT_EQ(scene->directional_lights[0].radiance, glm::vec3(2, 1, 0));
  EXPECT_TRUE(scene->point_lights.empty());
}

TEST(GltfLights, AScaledNodeScalesNeitherDirectionNorIntensity) {
  const auto scene = loadFile(withLight({{"type", "directional"}, {"intensity", 3}}, {{"scale", {9, 9, 9}}}));
  ASSERT_TRUE(scene) << sentence(scene.error());
  EXPECT_EQ(scene->directional_lights[0].direction_world, glm::dvec3(0, 0, -1));
  EXPECT_EQ(scene->directional_lights[0].radiance, glm::vec3(3));
}

TEST(GltfLights, PointAndSpotLightsKeepTheirPlaceRangeAndCone) {
  auto scene =
      loadFile(withLight({{"type", "point"}, {"intensity", 4}, {"range", 7}}, {{"translation", {1, 2, 3}}}));
  ASSERT_TRUE(scene) << sentence(scene.error());
  ASSERT_EQ(scene->point_lights.size(), 1U);
  EXPECT_EQ(scene->point_lights[0].p_world, glm::dvec3(1, 2, 3));
  EXPECT_EQ(scene->point_lights[0].intensity, glm::vec3(4));
  EXPECT_EQ(scene->point_lights[0].range_m, 7.0F);
  EXPECT_EQ(scene->point_lights[0].outer_cone_cos, -1.0F);
  EXPECT_TRUE(hasNote(*scene, "a faint one is added"));

  scene = loadFile(withLight({{"type", "spot"}, {"spot", {{"innerConeAngle", 0.5}, {"outerConeAngle", 1.0}}}},
                             {{"translation", {0, 0, 3}}}));
  ASSERT_TRUE(scene) << sentence(scene.error());
  EXPECT_FLOAT_EQ(scene->point_lights[0].inner_cone_cos, 0.87758256F);
  EXPECT_FLOAT_EQ(scene->point_lights[0].outer_cone_cos, 0.54030231F);
}

TEST(GltfLights, ASceneWithoutLightGetsOneFromAbove) {
  const auto scene = loadFile(triangleFile());
  ASSERT_TRUE(scene) << sentence(scene.error());
  ASSERT_EQ(scene->directional_lights.size(), 1U);
  EXPECT_LT(scene->directional_lights[0].direction_world.y, -0.5);
  EXPECT_NEAR(glm::length(scene->directional_lights[0].direction_world), 1.0, 1e-12);
  EXPECT_TRUE(hasNote(*scene, "The file has no light"));
}

TEST(GltfLights, PhysicalIntensitiesAreDimmedWithANote) {
  const auto scene = loadFile(withLight({{"type", "directional"}, {"intensity", 100000}}));
  ASSERT_TRUE(scene) << sentence(scene.error());
  EXPECT_NEAR(scene->directional_lights[0].radiance.x, 3.0F, 1e-5);
  EXPECT_TRUE(hasNote(*scene, "dimmed to 3e-05"));
}

// Lights of one kind in one place, of these intensities, named "lamp 0", "lamp 1", ...
json withLights(const std::string& type, const std::vector<double>& intensities) {
  json root = triangleFile();
  root["extensionsUsed"] = {"KHR_lights_punctual"};
  for (std::size_t i = 0; i < intensities.size(); ++i) {
    root["extensions"]["KHR_lights_punctual"]["lights"].push_back(
        {{"type", type}, {"intensity", intensities[i]}, {"name", "lamp " + std::to_string(i)}});
    json node = {{"translation", {0, 0, 5}}};
    node["extensions"]["KHR_lights_punctual"]["light"] = i;
    root["nodes"].push_back(node);
    root["scenes"][0]["nodes"].push_back(i + 1);
  }
  return root;
}

TEST(GltfLights, TheBrightestEightOfAKindAreKeptInTheirOrder) {
  const std::vector<double> intensities{1, 5, 0.25, 4, 3, 0.5, 2, 2, 2, 2};
  auto scene = loadFile(withLights("directional", intensities));
  ASSERT_TRUE(scene) << sentence(scene.error());
  std::vector<float> kept;
  for (const DirectionalLight& light : scene->directional_lights) {
    kept.push_back(light.radiance.x);
  }
  EXPECT_EQ(kept, (std::vector<float>{1, 5, 4, 3, 2, 2, 2, 2}));
  EXPECT_TRUE(hasNote(*scene,
                      "2 of 10 directional lights left out, the dimmest in the middle of the scene: "
                      "lamp 2 and lamp 5."));

  scene = loadFile(withLights("point", intensities));
  ASSERT_TRUE(scene) << sentence(scene.error());
  ASSERT_EQ(scene->point_lights.size(), 8U);
  EXPECT_EQ(scene->point_lights[2].intensity, glm::vec3(4));
  EXPECT_TRUE(hasNote(*scene, "2 of 10 point and spot lights left out"));
}

TEST(GltfLights, WhatIsFarAwayIsDimmerThanWhatIsNear) {
  json root = withLights("point", std::vector<double>(9, 2.0));
  root["nodes"][1]["translation"] = {0, 0, 50};
  const auto scene = loadFile(root);
  ASSERT_TRUE(scene) << sentence(scene.error());
  EXPECT_TRUE(hasNote(*scene,
                      "1 of 9 point and spot lights left out, the dimmest in the middle of the scene: "
                      "lamp 0."));
}

TEST(GltfLights, ManyThatAreLeftOutAreCountedAndNotAllNamed) {
  const auto scene = loadFile(withLights("point", std::vector<double>(20, 0.5)));
  ASSERT_TRUE(scene) << sentence(scene.error());
  EXPECT_TRUE(hasNote(*scene, ": lamp 8, lamp 9, lamp 10, lamp 11 and 8 more."));
}

// 32 lux of the eight that are drawn, not 40 of all.
TEST(GltfLights, OnlyThoseThatAreKeptDimTheOthers) {
  const auto scene = loadFile(withLights("directional", std::vector<double>(10, 4.0)));
  ASSERT_TRUE(scene) << sentence(scene.error());
  ASSERT_EQ(scene->directional_lights.size(), 8U);
  EXPECT_FLOAT_EQ(scene->directional_lights[0].radiance.x, 4.0F * 3.0F / 32.0F);
}

TEST(GltfLights, ALightThatIsNotThereIsRefusedByPlace) {
  json root = withLight({{"type", "point"}});
  root["nodes"][1]["extensions"]["KHR_lights_punctual"]["light"] = 1;
  const std::string refusal = refusalOf(root);
  EXPECT_NE(
      refusal.find("nodes[1].extensions.KHR_lights_punctual.light: could not load the scene: the value is 1"),
      std::string::npos)
      << refusal;
}

}  // namespace
}  // namespace ssrkit::test
