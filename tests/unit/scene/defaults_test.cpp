#include "scene/defaults.h"

#include <gtest/gtest.h>

#include <cmath>

#include "gltf_test_file.h"

namespace ssrkit::test {
namespace {

Expected<SceneDefaults> loadDefaults(const std::string& text) {
  const ScratchFolder folder;
  return loadSceneDefaults(folder.write("a.toml", text));
}

std::string defaultsRefusal(const std::string& text) {
  const auto defaults = loadDefaults(text);
  return defaults ? "" : sentence(defaults.error());
}

TEST(SceneDefaults, ReadEveryKey) {
  const auto defaults = loadDefaults(R"(
about = "One sentence."
pictured = "A thing."
look_for = "Its reflection."
camera = "front"
thickness_m = 0.3
thickness_rel = 0.05
max_distance_m = inf
origin_bias = 0.002
light_direction = [0, -2, 0.0]
light_radiance = [1, 2, 3.5]
sky_horizon = [0.1, 0.2, 0.3]
sky_zenith = [0, 0, 1]
environment = "skies/dusk.exr"
)");
  ASSERT_TRUE(defaults) << sentence(defaults.error());
  EXPECT_EQ(defaults->about, "One sentence.");
  EXPECT_EQ(defaults->pictured, "A thing.");
  EXPECT_EQ(defaults->look_for, "Its reflection.");
  EXPECT_EQ(defaults->camera, "front");
  EXPECT_EQ(defaults->parameters.thickness_m, 0.3);
  EXPECT_EQ(defaults->parameters.thickness_rel, 0.05);
  EXPECT_TRUE(std::isinf(defaults->parameters.max_distance_m));
  EXPECT_EQ(defaults->parameters.origin_bias, 0.002);
  EXPECT_EQ(defaults->light_direction_world, glm::dvec3(0, -1, 0));
  EXPECT_EQ(defaults->light_radiance, glm::vec3(1, 2, 3.5));
  EXPECT_EQ(defaults->sky_horizon, glm::vec3(0.1, 0.2, 0.3));
  EXPECT_EQ(defaults->sky_zenith, glm::vec3(0, 0, 1));
  ASSERT_TRUE(defaults->environment);
  EXPECT_TRUE(defaults->environment->file.is_absolute());  // beside the TOML file
  EXPECT_TRUE(defaults->environment->file.string().ends_with("/skies/dusk.exr"));
}

TEST(SceneDefaults, TakeAConstantForTheEnvironment) {
  const auto defaults = loadDefaults("environment = \"constant:1,0.5,0\"");
  ASSERT_TRUE(defaults) << sentence(defaults.error());
  EXPECT_EQ(*defaults->environment, (EnvironmentChoice{.file = {}, .constant = glm::vec3(1.0F, 0.5F, 0.0F)}));
  EXPECT_NE(
      defaultsRefusal("environment = \"constant:1,2\"").find("a.toml:1:15: could not read the environment"),
      std::string::npos)
      << defaultsRefusal("environment = \"constant:1,2\"");
  EXPECT_NE(defaultsRefusal("environment = \"\"").find("it names no file"), std::string::npos);
}

TEST(SceneDefaults, OfAnEmptyFileAreTheContracts) {
  const auto defaults = loadDefaults("");
  ASSERT_TRUE(defaults) << sentence(defaults.error());
  EXPECT_EQ(defaults->parameters, TraceParameters{});
  EXPECT_FALSE(defaults->light_direction_world);
}

TEST(SceneDefaults, AThicknessIsRelativeAloneWhereNoneInMetresIsGiven) {
  const auto alone = loadDefaults("thickness_rel = 0.05");
  ASSERT_TRUE(alone) << sentence(alone.error());
  EXPECT_EQ(alone->parameters.thickness_m, 0.0);
  EXPECT_EQ(alone->parameters.thickness_rel, 0.05);
  for (const char* both :
       {"thickness_rel = 0.05\nthickness_m = inf", "thickness_m = inf\nthickness_rel = 0.05"}) {
    const auto sum = loadDefaults(both);
    ASSERT_TRUE(sum) << sentence(sum.error());
    EXPECT_TRUE(std::isinf(sum->parameters.thickness_m));
  }
}

TEST(SceneDefaults, AnUnknownKeyIsRefusedAtItsPlace) {
  EXPECT_NE(defaultsRefusal("about = \"x\"\n  thicknes_m = 1\n")
                .find("a.toml:2:3: could not read the scene's defaults: there is no key 'thicknes_m'; did "
                      "you mean 'thickness_m'?"),
            std::string::npos)
      << defaultsRefusal("about = \"x\"\n  thicknes_m = 1\n");
}

TEST(SceneDefaults, BadSyntaxIsRefusedAtItsPlace) {
  EXPECT_NE(defaultsRefusal("about = \"x\"\ncamera = = 1")
                .find("a.toml:2:10: could not read the scene's defaults: "),
            std::string::npos)
      << defaultsRefusal("about = \"x\"\ncamera = = 1");
}

TEST(SceneDefaults, WrongTypesAreRefusedAtTheirPlace) {
  EXPECT_NE(defaultsRefusal("about = 3")
                .find("a.toml:1:9: could not read the scene's defaults: 'about' must be text"),
            std::string::npos);
  EXPECT_NE(defaultsRefusal("sky_zenith = [1, 2]").find("'sky_zenith' must be three numbers"),
            std::string::npos);
  EXPECT_NE(defaultsRefusal("sky_zenith = [1, 2, -1]").find("'sky_zenith' must lie between 0 and 1000"),
            std::string::npos);
  EXPECT_NE(defaultsRefusal("light_direction = [0, 0, 0]").find("must not be all zeros"), std::string::npos);
  EXPECT_NE(defaultsRefusal("light_direction = [0, nan, 0]").find("must be three numbers"),
            std::string::npos);
  EXPECT_NE(defaultsRefusal("thickness_m = [1]").find("'thickness_m' must be a number or text"),
            std::string::npos);
}

TEST(SceneDefaults, ParametersOutOfRangeAreRefusedAtTheirPlace) {
  EXPECT_NE(defaultsRefusal("thickness_m = -1").find("a.toml:1:15"), std::string::npos)
      << defaultsRefusal("thickness_m = -1");
}

TEST(SceneDefaults, TheLookBesideASceneIsApplied) {
  const ScratchFolder folder;
  folder.write("a.toml", "light_direction = [0, 0, -4]\nlight_radiance = [7, 7, 7]\nsky_zenith = [0, 1, 0]");
  const auto scene = loadScene(folder.write("a.gltf", triangleFile().dump()));
  ASSERT_TRUE(scene) << sentence(scene.error());
  EXPECT_EQ(scene->directional_lights[0].direction_world, glm::dvec3(0, 0, -1));
  EXPECT_EQ(scene->directional_lights[0].radiance, glm::vec3(7));
  EXPECT_EQ(scene->sky_zenith, glm::vec3(0, 1, 0));
}

TEST(SceneDefaults, ABrokenFileBesideASceneIsNotPassedOver) {
  const ScratchFolder folder;
  folder.write("a.toml", "nonsense = 1");
  EXPECT_FALSE(loadScene(folder.write("a.gltf", triangleFile().dump())));
}

}  // namespace
}  // namespace ssrkit::test
