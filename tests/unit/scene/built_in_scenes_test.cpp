#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "scene/defaults.h"
#include "scene/find_scene.h"
#include "scene/framing.h"
#include "scene/load.h"
#include "scene_folder.h"

namespace ssrkit {
namespace {

namespace fs = std::filesystem;

class BuiltInScene : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    const auto file = findScene(GetParam(), kScenes);
    ASSERT_TRUE(file) << sentence(file.error());
    auto scene = loadScene(*file);
    ASSERT_TRUE(scene) << sentence(scene.error());
    scene_ = *std::move(scene);
  }

  [[nodiscard]] const Material& materialOf(const Vertex& vertex) const {
    return scene_.materials[static_cast<std::size_t>(vertex.material_index)];
  }

  Scene scene_;
};

TEST_P(BuiltInScene, LoadsWithoutANote) {
  EXPECT_EQ(scene_.name, GetParam());
  EXPECT_TRUE(scene_.notes.empty()) << scene_.notes.front();
  EXPECT_EQ(scene_.directional_lights.size(), 1U);
}

TEST_P(BuiltInScene, HasMirrorsAndThingsThatAreNone) {
  bool mirrors = false;
  bool others = false;
  for (const Vertex& vertex : scene_.vertices) {
    (materialOf(vertex).mirror ? mirrors : others) = true;
  }
  EXPECT_TRUE(mirrors);
  EXPECT_TRUE(others);
}

TEST_P(BuiltInScene, KeepsEveryFlatMirrorExactlyFlat) {
  for (const Vertex& vertex : scene_.vertices) {
    if (materialOf(vertex).mirror && !materialOf(vertex).name.starts_with("sphere")) {
      EXPECT_LT(glm::distance(vertex.normal_world, vertex.face_normal_world), 1e-6F)
          << materialOf(vertex).name;
    }
  }
}

TEST_P(BuiltInScene, CoversItsVerticesWithRangesOnce) {
  std::uint32_t next = 0;
  for (const DrawRange& range : scene_.ranges) {
    EXPECT_EQ(range.first_vertex, next);
    next += range.vertex_count;
  }
  EXPECT_EQ(next, scene_.vertices.size());
}

TEST_P(BuiltInScene, SaysWhatItShowsAndWhatToLookFor) {
  const auto defaults = loadSceneDefaults(kScenes / GetParam() / (GetParam() + ".toml"));
  ASSERT_TRUE(defaults) << sentence(defaults.error());
  for (const std::string& text : {defaults->about, defaults->pictured, defaults->look_for}) {
    EXPECT_TRUE(text.ends_with('.')) << text;
  }
  const bool has_curved_mirrors = GetParam() == "curved" || GetParam() == "gloss";
  EXPECT_EQ(defaults->parameters.origin_bias, has_curved_mirrors ? 0.002 : 0.0);
}

INSTANTIATE_TEST_SUITE_P(All, BuiltInScene, testing::ValuesIn(builtInScenes(kScenes)));

TEST(BuiltInScenes, AreTwelve) {
  EXPECT_EQ(builtInScenes(kScenes).size(), 12U);
}

TEST(BuiltInScenes, TakeLessThanOneAndAHalfMegabytes) {
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(kScenes)) {
    bytes += entry.is_regular_file() ? entry.file_size() : 0;
  }
  EXPECT_LT(bytes, 1'500'000U);
}

TEST(BuiltInScenes, ClutterHasFourteenBoxesAndTenSpheres) {
  const auto scene = loadScene(kScenes / "clutter" / "clutter.gltf");
  ASSERT_TRUE(scene) << sentence(scene.error());
  // 12 triangles a box; 48 x 24 quads a sphere, but triangles at its poles; a floor and a wall in two parts.
  EXPECT_EQ(scene->vertices.size(), 3U * (14 * 12 + 10 * (2 * 48 * 24 - 2 * 48) + 2 + 4));
  EXPECT_NEAR(scene->cameras[0].fov_y_rad, 1.0471975511965976, 1e-15);
  const glm::dvec3 ahead = -glm::dvec3(glm::transpose(glm::dmat3(scene->cameras[0].view_from_world))[2]);
  EXPECT_NEAR(ahead.y, -0.20791169081775931, 1e-9);  // sin 12 degrees
}

TEST(BuiltInScenes, OutdoorReachesFromHalfAMetreToTwoKilometres) {
  const auto scene = loadScene(kScenes / "outdoor" / "outdoor.gltf");
  ASSERT_TRUE(scene) << sentence(scene.error());
  double nearest = 1e9;
  double farthest = 0.0;
  for (const Vertex& vertex : scene->vertices) {
    const double dist_view = -(scene->cameras[0].view_from_world * glm::dvec4(vertex.p_world, 1.0)).z;
    if (scene->materials[static_cast<std::size_t>(vertex.material_index)].name != "water") {
      nearest = std::min(nearest, dist_view);
      farthest = std::max(farthest, dist_view);
    }
  }
  EXPECT_GT(nearest, 0.5);
  EXPECT_LT(nearest, 1.0);
  EXPECT_GT(farthest, 2000.0);
  EXPECT_LT(farthest, scene->cameras[0].far_m);
}

}  // namespace
}  // namespace ssrkit
