// m1 to m4 against the numbers that their closed forms assume: f = 2, h = 1.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "scene/load.h"
#include "scene_folder.h"
#include "spaces/camera.h"

namespace ssrkit {
namespace {

// Throws, which fails the test, when the scene does not load.
Scene builtInScene(const std::string& name) {
  return loadScene(kScenes / name / (name + ".gltf"))
      .map_error([](const Error& error) { return sentence(error); })
      .value();
}

// The corners of the triangles whose material has this name.
std::vector<glm::dvec3> cornersOf(const Scene& scene, const std::string& material) {
  std::vector<glm::dvec3> corners;
  for (const Vertex& vertex : scene.vertices) {
    if (scene.materials[static_cast<std::size_t>(vertex.material_index)].name == material) {
      corners.emplace_back(vertex.p_world);
    }
  }
  return corners;
}

std::pair<double, double> extent(const std::vector<glm::dvec3>& corners, int axis) {
  const auto [low, high] = std::minmax_element(
      corners.begin(), corners.end(), [&](const auto& a, const auto& b) { return a[axis] < b[axis]; });
  return {(*low)[axis], (*high)[axis]};
}

glm::dvec2 pixelOf(const Camera& camera, const glm::dvec3& p_world) {
  const glm::dvec3 p_view(camera.view_from_world * glm::dvec4(p_world, 1.0));
  const PixelProjection projection = pixelProjection(camera);
  return projection.px_scale * glm::dvec2(p_view) / -p_view.z + projection.px_offset;
}

class ClosedFormScene : public testing::TestWithParam<std::string> {};

TEST_P(ClosedFormScene, HasItsCameraInTheOriginLookingAlongMinusZWithFocalLengthTwo) {
  const Scene scene = builtInScene(GetParam());
  ASSERT_EQ(scene.cameras.size(), 1U);
  EXPECT_EQ(scene.cameras[0].view_from_world, glm::dmat4(1.0));
  EXPECT_NEAR(1.0 / std::tan(0.5 * scene.cameras[0].fov_y_rad), 2.0, 1e-15);
  EXPECT_TRUE(scene.notes.empty());
}

TEST_P(ClosedFormScene, HasItsFloorOneMetreBelow) {
  const Scene scene = builtInScene(GetParam());
  const auto corners = cornersOf(scene, GetParam() == "m1" || GetParam() == "m3" ? "floor mirror" : "floor");
  ASSERT_EQ(corners.size(), 6U);
  EXPECT_EQ(extent(corners, 1), std::pair(-1.0, -1.0));
  // Below the image's lower edge (Y = -1, at a distance of h f = 2 m) nothing of it is missing at 21:9.
  EXPECT_GE(extent(corners, 2).second, -2.0);
  EXPECT_GT(extent(corners, 0).second, 21.0 / 9.0 / 2.0 * 8.0);
}

INSTANTIATE_TEST_SUITE_P(All, ClosedFormScene, testing::Values("m1", "m2", "m3", "m4"));

TEST(SceneM1, TheFloorMeetsTheWallOnRow160Of256) {
  const Scene scene = builtInScene("m1");
  const Camera camera = cameraFor(scene.cameras[0], {256, 256});
  int on_contact = 0;
  for (const std::string material : {"floor mirror", "wall"}) {
    for (const glm::dvec3& corner : cornersOf(scene, material)) {
      if (corner.z == -8.0 && corner.y == -1.0) {
        EXPECT_NEAR(pixelOf(camera, corner).y, 160.0, 1e-12);
        ++on_contact;
      }
    }
  }
  EXPECT_EQ(on_contact, 6);  // three triangle corners each
}

TEST(SceneM1, TheWallFillsTheImageAboveTheContactUpTo21To9) {
  const Scene scene = builtInScene("m1");
  const auto wall = cornersOf(scene, "wall");
  EXPECT_EQ(extent(wall, 2), std::pair(-8.0, -8.0));
  const Camera camera = cameraFor(scene.cameras[0], {2520, 1080});
  EXPECT_LT(pixelOf(camera, {extent(wall, 0).first, extent(wall, 1).second, -8.0}).x, 0.0);
  EXPECT_LT(pixelOf(camera, {extent(wall, 0).first, extent(wall, 1).second, -8.0}).y, 0.0);
  EXPECT_GT(pixelOf(camera, {extent(wall, 0).second, 0.0, -8.0}).x, 2520.0);
}

TEST(SceneM1, OnlyTheFloorIsAMirror) {
  const Scene scene = builtInScene("m1");
  for (const Material& material : scene.materials) {
    EXPECT_EQ(material.mirror, material.name == "floor mirror") << material.name;
  }
}

TEST(SceneM1, ThePictureOnTheWallIsNotItsOwnMirrorImage) {
  const Scene scene = builtInScene("m1");
  ASSERT_EQ(scene.textures.size(), 1U);
  const Texture& texture = scene.textures[0];
  const auto texel = [&](int x, int y) {
    const auto at = 4 * static_cast<std::size_t>(y * texture.size.width + x);
    return std::array{texture.rgba[at], texture.rgba[at + 1], texture.rgba[at + 2]};
  };
  // Rows and columns that equal their mirror images; a picture with a symmetry would have all of them equal.
  int differing_columns = 0;
  int differing_rows = 0;
  for (int y = 0; y < texture.size.height; ++y) {
    for (int x = 0; x < texture.size.width; ++x) {
      differing_columns += texel(x, y) != texel(texture.size.width - 1 - x, y) ? 1 : 0;
      differing_rows += texel(x, y) != texel(x, texture.size.height - 1 - y) ? 1 : 0;
    }
  }
  EXPECT_GT(differing_columns, 1000);
  EXPECT_GT(differing_rows, 1000);
}

TEST(SceneM2, TheMirrorStandsFourMetresAheadAndTheFloorReachesBehindTheCamera) {
  const Scene scene = builtInScene("m2");
  const auto mirror = cornersOf(scene, "wall mirror");
  EXPECT_EQ(extent(mirror, 2), std::pair(-4.0, -4.0));
  EXPECT_EQ(extent(mirror, 1).first, -1.0);
  for (const Vertex& vertex : scene.vertices) {
    if (vertex.p_world.y > 0.0F) {
      EXPECT_EQ(vertex.face_normal_world, glm::vec3(0, 0, 1));
    }
  }
  const auto floor = cornersOf(scene, "floor");
  EXPECT_EQ(extent(floor, 2).first, -4.0);
  // The lowest row of the mirror shows the floor at a depth of 2 D - h f / |Y|; upwards it recedes behind the
  // camera.
  EXPECT_GE(extent(floor, 2).second, 4.0);
  EXPECT_TRUE(std::none_of(scene.materials.begin(), scene.materials.end(), [](const Material& material) {
    return material.name == "floor" && material.mirror;
  }));
}

TEST(SceneM3, TheQuadFloatsFourMetresAheadBetweenItsRows) {
  const Scene scene = builtInScene("m3");
  const auto quad = cornersOf(scene, "floating quad");
  ASSERT_EQ(quad.size(), 6U);
  EXPECT_EQ(extent(quad, 2), std::pair(-4.0, -4.0));
  const Camera camera = cameraFor(scene.cameras[0], {256, 256});
  // Y = -0.1 and 0.3, rows counted from the top: 128 (1 - Y).
  EXPECT_NEAR(pixelOf(camera, {0.0, extent(quad, 1).first, -4.0}).y, 140.8, 1e-5);
  EXPECT_NEAR(pixelOf(camera, {0.0, extent(quad, 1).second, -4.0}).y, 89.6, 1e-5);
  EXPECT_EQ(cornersOf(scene, "wall").size(), 6U);
}

TEST(SceneM4, ThePrincipalRayTurnsAtConstantDepthAndMeetsTheWallAtHalfTheHalfWidth) {
  const Scene scene = builtInScene("m4");
  glm::dvec3 normal(0.0);
  for (const Vertex& vertex : scene.vertices) {
    if (scene.materials[static_cast<std::size_t>(vertex.material_index)].name == "slanted mirror") {
      normal = glm::dvec3(vertex.face_normal_world);
      EXPECT_EQ(vertex.p_world.x + vertex.p_world.z, -4.0F);  // the plane through (0, 0, -4)
      EXPECT_EQ(vertex.normal_world, vertex.face_normal_world);
    }
  }
  EXPECT_NEAR(glm::distance(glm::reflect(glm::dvec3(0, 0, -1), normal), glm::dvec3(1, 0, 0)), 0.0, 1e-7);
  const auto wall = cornersOf(scene, "side wall");
  EXPECT_EQ(extent(wall, 0), std::pair(1.0, 1.0));
  EXPECT_LT(extent(wall, 2).first, -4.0);
  EXPECT_GT(extent(wall, 2).second, -4.0);
  // X' = f x_w / (a D) = 2 * 1 / (1 * 4), so column 192 of 256; the mirror's edge does not hide it.
  const Camera camera = cameraFor(scene.cameras[0], {256, 256});
  EXPECT_NEAR(pixelOf(camera, {1.0, 0.0, -4.0}).x, 192.0, 1e-12);
  EXPECT_LT(pixelOf(camera, {0.75, 0.0, -4.75}).x, 192.0);
}

}  // namespace
}  // namespace ssrkit
