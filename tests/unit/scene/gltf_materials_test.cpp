#include <gtest/gtest.h>

#include "gltf_test_file.h"

namespace ssrkit::test {
namespace {

using nlohmann::json;

// The triangle with this material, texture coordinates 0..1 and one red PNG as textures[0].
json withMaterial(const json& material) {
  json root = triangleFile();
  root["materials"] = {material};
  root["meshes"][0]["primitives"][0]["material"] = 0;
  root["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] =
      addAccessor(root, bytesOf<float>({0, 1, 1, 1, 0, 0}), kFloat, 3, "VEC2");
  root["images"] = {{{"bufferView", addView(root, plainPng(4, 2, 200, 10, 30))}, {"mimeType", "image/png"}}};
  root["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}}};
  root["textures"] = {{{"source", 0}, {"sampler", 0}}};
  return root;
}

TEST(GltfMaterials, FactorsAreReadAsTheyAre) {
  const auto scene = loadFile(withMaterial(
      {{"name", "  brass "},
       {"pbrMetallicRoughness",
        {{"baseColorFactor", {0.5, 0.25, 0.125, 0.75}}, {"metallicFactor", 0.5}, {"roughnessFactor", 0.25}}},
       {"emissiveFactor", {1, 0.5, 0}},
       {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}}}},
       {"alphaMode", "MASK"},
       {"alphaCutoff", 0.25},
       {"doubleSided", true}}));
  ASSERT_TRUE(scene) << sentence(scene.error());
  const Material& material = scene->materials[0];
  EXPECT_EQ(material.name, "brass");
  EXPECT_EQ(material.base_colour, glm::vec4(0.5, 0.25, 0.125, 0.75));
  EXPECT_EQ(material.metallic, 0.5F);
  EXPECT_EQ(material.roughness, 0.25F);
  EXPECT_EQ(material.emissive, glm::vec3(4, 2, 0));
  EXPECT_EQ(material.alpha_mode, AlphaMode::kMask);
  EXPECT_EQ(material.alpha_cutoff, 0.25F);
  EXPECT_TRUE(material.double_sided);
  EXPECT_TRUE(material.mirror);
  EXPECT_EQ(material.base_colour_texture, -1);
}

TEST(GltfMaterials, TexturesAreDecodedWithTheirWrapModes) {
  const auto scene = loadFile(withMaterial({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
                                            {"emissiveTexture", {{"index", 0}}}}));
  ASSERT_TRUE(scene) << sentence(scene.error());
  ASSERT_EQ(scene->textures.size(), 1U);
  const Texture& texture = scene->textures[0];
  EXPECT_EQ(texture.size, (Size{4, 2}));
  EXPECT_EQ(texture.wrap_u, Wrap::kClamp);
  EXPECT_EQ(texture.wrap_v, Wrap::kMirror);
  ASSERT_EQ(texture.rgba.size(), 32U);
  EXPECT_EQ(std::vector<std::uint8_t>(texture.rgba.end() - 4, texture.rgba.end()),
            (std::vector<std::uint8_t>{200, 10, 30, 255}));
  EXPECT_EQ(scene->materials[0].base_colour_texture, 0);
  EXPECT_EQ(scene->materials[0].emissive_texture, 0);
  EXPECT_EQ(scene->materials[0].normal_texture, -1);
}

TEST(GltfMaterials, AnImageBesideTheFileIsFoundByItsEscapedName) {
  json root = withMaterial({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  root["images"] = {{{"uri", "my%20image.png"}}};
  const ScratchFolder folder;
  const std::vector<std::uint8_t> png = plainPng(3, 3, 1, 2, 3);
  folder.write("my image.png", std::string(png.begin(), png.end()));
  const auto scene = loadScene(folder.write("a.gltf", root.dump()));
  ASSERT_TRUE(scene) << sentence(scene.error());
  EXPECT_EQ(scene->textures[0].size, (Size{3, 3}));
}

TEST(GltfMaterials, ANormalMapGetsTangents) {
  json root = withMaterial({{"normalTexture", {{"index", 0}, {"scale", 0.5}}}});
  const auto flat = loadFile(root);
  ASSERT_TRUE(flat) << sentence(flat.error());
  EXPECT_EQ(flat->materials[0].normal_scale, 0.5F);
  EXPECT_EQ(flat->vertices[0].tangent_world, glm::vec4(1, 0, 0, 1));
  // A quarter turn about z takes the tangent with it; so does one about y.
  root["nodes"][0]["matrix"] = {0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1};
  const auto turned = loadFile(root);
  ASSERT_TRUE(turned) << sentence(turned.error());
  EXPECT_EQ(turned->vertices[0].tangent_world, glm::vec4(0, 0, -1, 1));
}

TEST(GltfMaterials, ATextureTransformMovesTheCoordinates) {
  json info = {{"index", 0},
               {"extensions", {{"KHR_texture_transform", {{"offset", {0.5, 0.25}}, {"scale", {2, 3}}}}}}};
  auto scene = loadFile(withMaterial({{"pbrMetallicRoughness", {{"baseColorTexture", info}}}}));
  ASSERT_TRUE(scene) << sentence(scene.error());
  EXPECT_EQ(scene->vertices[1].uv, glm::vec2(2.5, 3.25));

  // The extension's rotation is counter-clockwise in the image: (1, 0) goes to (0, -1) with v downwards.
  info["extensions"]["KHR_texture_transform"] = {{"rotation", 1.5707963267948966}};
  scene = loadFile(withMaterial({{"pbrMetallicRoughness", {{"baseColorTexture", info}}}}));
  ASSERT_TRUE(scene) << sentence(scene.error());
  EXPECT_NEAR(glm::distance(scene->vertices[1].uv, glm::vec2(1, -1)), 0.0, 1e-6);
}

TEST(GltfMaterials, ATextureTransformChoosesItsOwnSetOfCoordinates) {
  json root = withMaterial(
      {{"emissiveTexture", {{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"texCoord", 1}}}}}}}});
  root["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_1"] =
      addAccessor(root, bytesOf<float>({0, 9, 1, 9, 0, 8}), kFloat, 3, "VEC2");
  const auto scene = loadFile(root);
  ASSERT_TRUE(scene) << sentence(scene.error());
  EXPECT_EQ(scene->vertices[1].uv, glm::vec2(1, 9));
}

TEST(GltfMaterials, ATextureTransformThatIsNoneIsRefusedByPlace) {
  const auto refusalWith = [](const std::string& texture, const json& transform) {
    const json info = {{"index", 0}, {"extensions", {{"KHR_texture_transform", transform}}}};
    const bool is_pbr = texture == "baseColorTexture" || texture == "metallicRoughnessTexture";
    return refusalOf(
        withMaterial(is_pbr ? json{{"pbrMetallicRoughness", {{texture, info}}}} : json{{texture, info}}));
  };
  const auto holds = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  };
  for (const char* texture :
       {"baseColorTexture", "metallicRoughnessTexture", "normalTexture", "emissiveTexture"}) {
    const std::string place = std::string(texture) + ".extensions.KHR_texture_transform";
    for (const json& set : {json(1e300), json(-1), json(1.5), json("1")}) {
      const std::string refusal = refusalWith(texture, {{"texCoord", set}});
      EXPECT_TRUE(holds(refusal, place + ".texCoord") && holds(refusal, "not a whole number")) << refusal;
    }
    EXPECT_TRUE(holds(refusalWith(texture, {{"offset", {1}}}), place + ".offset")) << texture;
    EXPECT_TRUE(holds(refusalWith(texture, {{"scale", 2}}), place + ".scale")) << texture;
    EXPECT_TRUE(holds(refusalWith(texture, {{"rotation", "half"}}), place + ".rotation")) << texture;
  }
}

TEST(GltfMaterials, MaterialsWithTheSameTexturesShareARange) {
  json root = withMaterial({{"name", "red"}});
  root["materials"].push_back({{"name", "blue"}});
  root["materials"].push_back({{"name", "textured"}, {"emissiveTexture", {{"index", 0}}}});
  for (const int material : {2, 1, 2}) {
    json primitive = root["meshes"][0]["primitives"][0];
    primitive["material"] = material;
    root["meshes"][0]["primitives"].push_back(primitive);
  }
  const auto scene = loadFile(root);
  ASSERT_TRUE(scene) << sentence(scene.error());
  ASSERT_EQ(scene->ranges.size(), 2U);
  EXPECT_EQ(scene->ranges[0].first_vertex, 0U);
  EXPECT_EQ(scene->ranges[0].vertex_count, 6U);
  EXPECT_EQ(scene->vertices[0].material_index, 0.0F);
  EXPECT_EQ(scene->vertices[3].material_index, 1.0F);
  EXPECT_EQ(scene->ranges[1].first_vertex, 6U);
  EXPECT_EQ(scene->ranges[1].vertex_count, 6U);
  EXPECT_EQ(scene->ranges[1].material_index, 2);
}

TEST(Mirrors, AreSmoothMetals) {
  const auto isMirror = [](double metallic, double roughness) {
    json root = withMaterial(
        {{"pbrMetallicRoughness", {{"metallicFactor", metallic}, {"roughnessFactor", roughness}}}});
    json other = root["meshes"][0]["primitives"][0];
    other["material"] = 1;
    root["meshes"][0]["primitives"].push_back(other);
    root["materials"].push_back({{"pbrMetallicRoughness", {{"roughnessFactor", 0}}}});
    return loadFile(root)->materials[0].mirror;
  };
  EXPECT_TRUE(isMirror(0.5, 0.3));
  EXPECT_TRUE(isMirror(1, 0));
  EXPECT_FALSE(isMirror(0.49, 0.1));
  EXPECT_FALSE(isMirror(1, 0.31));
}

TEST(Mirrors, TheFileCanSayItOtherwise) {
  json root = withMaterial({{"extras", {{"ssrkit_mirror", true}}}});
  EXPECT_TRUE(loadFile(root)->materials[0].mirror);
  EXPECT_FALSE(hasNote(*loadFile(root), "Nothing in the scene is a mirror"));
}

TEST(Mirrors, WithoutOneEverythingMirrorsAndANoteSaysSo) {
  const auto scene = loadFile(withMaterial({{"name", "matt"}}));
  ASSERT_TRUE(scene) << sentence(scene.error());
  EXPECT_TRUE(scene->materials[0].mirror);
  EXPECT_TRUE(hasNote(*scene, "Nothing in the scene is a mirror, so everything is one; --mirror MATERIAL"));
}

TEST(Mirrors, AMirrorThatNoTriangleHasDoesNotCount) {
  json root = withMaterial({{"name", "matt"}});
  root["materials"].push_back({{"name", "unused"}, {"pbrMetallicRoughness", {{"roughnessFactor", 0}}}});
  EXPECT_TRUE(loadFile(root)->materials[0].mirror);
}

TEST(Mirrors, ANamedOneIsTheOnlyOne) {
  json root = withMaterial({{"name", "matt"}});
  root["materials"].push_back({{"name", "shiny"}, {"pbrMetallicRoughness", {{"roughnessFactor", 0}}}});
  const auto scene = loadFile(root, {.mirror_material = "matt", .camera_name = ""});
  ASSERT_TRUE(scene) << sentence(scene.error());
  EXPECT_TRUE(scene->materials[0].mirror);
  EXPECT_FALSE(scene->materials[1].mirror);
}

TEST(Mirrors, AnUnknownNameIsRefusedWithTheNames) {
  const std::string refusal =
      refusalOf(withMaterial({{"name", "matt"}}), {.mirror_material = "mat", .camera_name = ""});
  EXPECT_NE(refusal.find("it has no material 'mat' to mirror; did you mean 'matt'? its materials are matt"),
            std::string::npos)
      << refusal;
}

}  // namespace
}  // namespace ssrkit::test
