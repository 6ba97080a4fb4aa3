#include <gtest/gtest.h>

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
