#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "gltf_test_file.h"

namespace ssrkit::test {
namespace {

using nlohmann::json;

// Unit square corners 0..3: (0,0) (1,0) (0,1) (1,1), as a strip covers it.
const std::vector<float> kSquare{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};

TEST(GltfGeometry, ATriangleKeepsItsCornersAndGetsItsFaceNormal) {
  const auto scene = loadFile(triangleFile());
  ASSERT_TRUE(scene) << sentence(scene.error());
  ASSERT_EQ(scene->vertices.size(), 3U);
  EXPECT_EQ(scene->vertices[0].p_world, glm::vec3(0, 0, 0));
  EXPECT_EQ(scene->vertices[1].p_world, glm::vec3(1, 0, 0));
  EXPECT_EQ(scene->vertices[2].p_world, glm::vec3(0, 1, 0));
  for (const Vertex& vertex : scene->vertices) {
    EXPECT_EQ(vertex.face_normal_world, glm::vec3(0, 0, 1));
    EXPECT_EQ(vertex.normal_world, glm::vec3(0, 0, 1));
    EXPECT_EQ(vertex.tangent_world, glm::vec4(1, 0, 0, 1));
  }
  ASSERT_EQ(scene->ranges.size(), 1U);
  EXPECT_EQ(scene->ranges[0].vertex_count, 3U);
}

TEST(GltfGeometry, EveryTypeOfIndexGivesTheSameTriangle) {
  const std::array<std::pair<int, std::vector<std::uint8_t>>, 3> types{
      {{kUnsignedByte, {2, 0, 1}},
       {kUnsignedShort, bytesOf<std::uint16_t>({2, 0, 1})},
       {kUnsignedInt, bytesOf<std::uint32_t>({2, 0, 1})}}};
  for (const auto& [type, bytes] : types) {
    json root = triangleFile();
    primitiveOf(root)["indices"] = addAccessor(root, bytes, type, 3, "SCALAR");
    const auto scene = loadFile(root);
    ASSERT_TRUE(scene) << sentence(scene.error());
    EXPECT_EQ(scene->vertices[0].p_world, glm::vec3(0, 1, 0)) << type;
    EXPECT_EQ(scene->vertices[1].p_world, glm::vec3(0, 0, 0)) << type;
  }
}

TEST(GltfGeometry, AStripTurnsEverySecondTriangleOver) {
  json root = triangleFile();
  setPositions(root, kSquare);
  primitiveOf(root)["mode"] = 5;
  const auto scene = loadFile(root);
  ASSERT_TRUE(scene) << sentence(scene.error());
  ASSERT_EQ(scene->vertices.size(), 6U);
  EXPECT_EQ(scene->vertices[3].p_world, glm::vec3(1, 0, 0));
  EXPECT_EQ(scene->vertices[4].p_world, glm::vec3(1, 1, 0));
  EXPECT_EQ(scene->vertices[5].p_world, glm::vec3(0, 1, 0));
  EXPECT_EQ(scene->vertices[3].face_normal_world, glm::vec3(0, 0, 1));
}

TEST(GltfGeometry, AFanTurnsAboutItsFirstCorner) {
  json root = triangleFile();
  setPositions(root, {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
  primitiveOf(root)["mode"] = 6;
  const auto scene = loadFile(root);
  ASSERT_TRUE(scene) << sentence(scene.error());
  ASSERT_EQ(scene->vertices.size(), 6U);
  EXPECT_EQ(scene->vertices[5].p_world, glm::vec3(0, 0, 0));
  EXPECT_EQ(scene->vertices[0].face_normal_world, glm::vec3(0, 0, 1));
  EXPECT_EQ(scene->vertices[3].face_normal_world, glm::vec3(0, 0, 1));
}

TEST(GltfGeometry, PointsAndLinesAreLeftOutWithANote) {
  for (int mode = 0; mode <= 3; ++mode) {
    json root = triangleFile();
    root["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}, {"mode", mode}});
    const auto scene = loadFile(root);
    ASSERT_TRUE(scene) << sentence(scene.error());
    EXPECT_EQ(scene->vertices.size(), 3U);
    EXPECT_TRUE(hasNote(*scene, "1 primitive of points or lines left out"));
  }
}

TEST(GltfGeometry, NormalisedIntegersAreFractions) {
  json root = triangleFile();
  primitiveOf(root)["attributes"]["POSITION"] = addAccessor(
      root, bytesOf<std::int16_t>({0, 0, 0, 32767, 0, 0, 0, -32768, 16384}), kShort, 3, "VEC3", true);
  const auto scene = loadFile(root);
  ASSERT_TRUE(scene) << sentence(scene.error());
  EXPECT_EQ(scene->vertices[1].p_world, glm::vec3(1, 0, 0));
  EXPECT_EQ(scene->vertices[2].p_world, glm::vec3(0, -1, 16384.0F / 32767.0F));
}

TEST(GltfGeometry, PlainIntegersAreTheirValues) {
  json root = triangleFile();
  primitiveOf(root)["attributes"]["POSITION"] =
      addAccessor(root, bytesOf<std::int8_t>({0, 0, 0, 127, 0, 0, 0, -128, 5}), kByte, 3, "VEC3");
  const auto scene = loadFile(root);
  ASSERT_TRUE(scene) << sentence(scene.error());
  EXPECT_EQ(scene->vertices[1].p_world, glm::vec3(127, 0, 0));
  EXPECT_EQ(scene->vertices[2].p_world, glm::vec3(0, -128, 5));
}

TEST(GltfGeometry, AStrideSkipsWhatLiesBetweenTheElements) {
  json root = triangleFile();
  const int accessor =
      addAccessor(root, bytesOf<float>({9, 0, 0, 0, 9, 9, 1, 0, 0, 9, 9, 0, 1, 0, 9}), kFloat, 3, "VEC3");
  root["accessors"][accessor]["byteOffset"] = 4;
  root["bufferViews"].back()["byteStride"] = 20;
  primitiveOf(root)["attributes"]["POSITION"] = accessor;
  const auto scene = loadFile(root);
  ASSERT_TRUE(scene) << sentence(scene.error());
  EXPECT_EQ(scene->vertices[0].p_world, glm::vec3(0, 0, 0));
  EXPECT_EQ(scene->vertices[1].p_world, glm::vec3(1, 0, 0));
  EXPECT_EQ(scene->vertices[2].p_world, glm::vec3(0, 1, 0));
}

TEST(GltfGeometry, SparseValuesReplaceThoseOfTheirIndices) {
  json root = triangleFile();
  const int indices = addView(root, {2});
  const int values = addView(root, bytesOf<float>({0, 7, 0}));
  root["accessors"][0]["sparse"] = {{"count", 1},
                                    {"indices", {{"bufferView", indices}, {"componentType", kUnsignedByte}}},
                                    {"values", {{"bufferView", values}}}};
  const auto scene = loadFile(root);
  ASSERT_TRUE(scene) << sentence(scene.error());
  EXPECT_EQ(scene->vertices[1].p_world, glm::vec3(1, 0, 0));
  EXPECT_EQ(scene->vertices[2].p_world, glm::vec3(0, 7, 0));
}

TEST(GltfGeometry, TransformsOfTheHierarchyMultiply) {
  json root = triangleFile();
  // The parent turns 90 degrees about z, (x, y) -> (-y, x), and moves; the child scales first.
  root["nodes"] = {{{"children", {1}},
                    {"rotation", {0, 0, 0.7071067811865476, 0.7071067811865476}},
                    {"translation", {10, 0, 0}}},
                   {{"mesh", 0}, {"scale", {2, 3, 1}}}};
  const auto scene = loadFile(root);
  ASSERT_TRUE(scene) << sentence(scene.error());
  EXPECT_NEAR(glm::distance(scene->vertices[1].p_world, glm::vec3(10, 2, 0)), 0.0, 1e-6);
  EXPECT_NEAR(glm::distance(scene->vertices[2].p_world, glm::vec3(7, 0, 0)), 0.0, 1e-6);
}

TEST(GltfGeometry, AMatrixIsReadColumnByColumn) {
  json root = triangleFile();
  root["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 5, 6, 7, 1};  // y becomes z
  const auto scene = loadFile(root);
  ASSERT_TRUE(scene) << sentence(scene.error());
  EXPECT_EQ(scene->vertices[2].p_world, glm::vec3(5, 6, 8));
  EXPECT_EQ(scene->vertices[0].face_normal_world, glm::vec3(0, -1, 0));
}

TEST(GltfGeometry, AMirroringTransformKeepsTheOutsideOut) {
  json root = triangleFile();
  root["nodes"][0]["scale"] = {-1, 1, 1};
  primitiveOf(root)["attributes"]["NORMAL"] =
      addAccessor(root, bytesOf<float>({0, 0, 2, 0, 0, 2, 0, 0, 2}), kFloat, 3, "VEC3");
  const auto scene = loadFile(root);
  ASSERT_TRUE(scene) << sentence(scene.error());
  EXPECT_EQ(scene->vertices[0].face_normal_world, glm::vec3(0, 0, 1));
  EXPECT_EQ(scene->vertices[0].normal_world, glm::vec3(0, 0, 1));
}

TEST(GltfGeometry, NormalsStandOnStretchedSurfaces) {
  json root = triangleFile();
  // The plane x + y = 1 stretched 2x along x becomes x / 2 + y = 1 with the normal (1, 2, 0) / sqrt 5.
  setPositions(root, {1, 0, 0, 0, 1, 0, 0, 1, 1});
  const float half = 0.70710678F;
  primitiveOf(root)["attributes"]["NORMAL"] =
      addAccessor(root, bytesOf<float>({half, half, 0, half, half, 0, half, half, 0}), kFloat, 3, "VEC3");
  root["nodes"][0]["scale"] = {2, 1, 1};
  const auto scene = loadFile(root);
  ASSERT_TRUE(scene) << sentence(scene.error());
  EXPECT_NEAR(scene->vertices[0].normal_world.x, 0.4472136F, 1e-6);
  EXPECT_NEAR(scene->vertices[0].normal_world.y, 0.8944272F, 1e-6);
}

TEST(GltfGeometry, TrianglesWithoutAreaAreDroppedWithANote) {
  json root = triangleFile();
  setPositions(root, {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 1, 2, 2, 2});
  const auto scene = loadFile(root);
  ASSERT_TRUE(scene) << sentence(scene.error());
  EXPECT_EQ(scene->vertices.size(), 3U);
  EXPECT_TRUE(hasNote(*scene, "1 triangle without area left out"));
}

TEST(GltfGeometry, ASliverIsKept) {
  json root = triangleFile();
  setPositions(root, {0, 0, 0, 1000, 0, 0, 1000, 0.01F, 0});
  const auto scene = loadFile(root);
  ASSERT_TRUE(scene) << sentence(scene.error());
  EXPECT_EQ(scene->vertices.size(), 3U);
}

TEST(GltfGeometry, NormalsOfNoLengthBecomeTheFaces) {
  json root = triangleFile();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  primitiveOf(root)["attributes"]["NORMAL"] =
      addAccessor(root, bytesOf<float>({0, 0, 0, 0, nan, 0, 1, 0, 0}), kFloat, 3, "VEC3");
  const auto scene = loadFile(root);
  ASSERT_TRUE(scene) << sentence(scene.error());
  EXPECT_EQ(scene->vertices[0].normal_world, glm::vec3(0, 0, 1));
  EXPECT_EQ(scene->vertices[1].normal_world, glm::vec3(0, 0, 1));
  EXPECT_EQ(scene->vertices[2].normal_world, glm::vec3(1, 0, 0));
  EXPECT_TRUE(hasNote(*scene, "2 normals of no length"));
}

TEST(GltfGeometry, SkinsAndMorphsAreNoted) {
  json root = triangleFile();
  root["skins"] = {{{"joints", {0}}}};
  root["nodes"][0]["skin"] = 0;
  primitiveOf(root)["targets"] = {{{"POSITION", 0}}};
  const auto scene = loadFile(root);
  ASSERT_TRUE(scene) << sentence(scene.error());
  EXPECT_TRUE(hasNote(*scene, "1 skinned mesh drawn in the bind pose"));
  EXPECT_TRUE(hasNote(*scene, "1 primitive drawn without morph targets"));
}

// A shadow caster's shader discards, or does not, for all of a range.
TEST(GltfGeometry, OpaqueAndCutOutMaterialsShareNoRange) {
  for (const auto& [first, second] :
       {std::pair{"OPAQUE", "BLEND"}, std::pair{"BLEND", "OPAQUE"}, std::pair{"OPAQUE", "MASK"}}) {
    json root = triangleFile();
    root["materials"] = {{{"alphaMode", first}}, {{"alphaMode", second}}, {{"alphaMode", first}}};
    const json triangle = primitiveOf(root);
    root["meshes"][0]["primitives"] = {triangle, triangle, triangle};
    for (int i = 0; i < 3; ++i) {
      root["meshes"][0]["primitives"][i]["material"] = i;
    }
    const auto scene = loadFile(root);
    ASSERT_TRUE(scene) << sentence(scene.error());
    ASSERT_EQ(scene->ranges.size(), 2U) << first;
    EXPECT_EQ(scene->ranges[0].vertex_count, 6U) << "those of one kind stay together";
    for (const DrawRange& range : scene->ranges) {
      const auto is_opaque = [&](float material) {
        return scene->materials[static_cast<std::size_t>(material)].alpha_mode == AlphaMode::kOpaque;
      };
      for (std::uint32_t i = 0; i < range.vertex_count; ++i) {
        EXPECT_EQ(is_opaque(scene->vertices[range.first_vertex + i].material_index),
                  is_opaque(static_cast<float>(range.material_index)))
            << first << " before " << second;
      }
    }
  }
}

TEST(GltfGeometry, OnlyTheDefaultSceneIsDrawn) {
  json root = triangleFile();
  root["nodes"].push_back({{"mesh", 0}, {"translation", {0, 0, 5}}});
  root["scenes"].push_back({{"nodes", {1}}});
  root["scene"] = 1;
  const auto scene = loadFile(root);
  ASSERT_TRUE(scene) << sentence(scene.error());
  ASSERT_EQ(scene->vertices.size(), 3U);
  EXPECT_EQ(scene->vertices[0].p_world.z, 5.0F);
  EXPECT_TRUE(hasNote(*scene, "2 scenes"));
}

}  // namespace
}  // namespace ssrkit::test
