#include <gtest/gtest.h>

#include "gltf_test_file.h"
#include "spaces/camera.h"

namespace ssrkit::test {
namespace {

using nlohmann::json;

json withCamera(const json& node, const json& lens) {
  json root = triangleFile();
  root["cameras"].push_back({{"name", " eye\n"}, {"type", "perspective"}, {"perspective", lens}});
  json camera_node = node;
  camera_node["camera"] = root["cameras"].size() - 1;
  root["nodes"].push_back(camera_node);
  root["scenes"][0]["nodes"].push_back(root["nodes"].size() - 1);
  return root;
}

const json kLens{{"yfov", 1.0}, {"znear", 0.25}, {"zfar", 50}};

void addOrthographic(json& root, const std::string& name) {
  root["cameras"].push_back({{"name", name},
                             {"type", "orthographic"},
                             {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 0.1}, {"zfar", 9}}}});
  root["nodes"].push_back({{"camera", root["cameras"].size() - 1}});
  root["scenes"][0]["nodes"].push_back(root["nodes"].size() - 1);
}

TEST(GltfCameras, APerspectiveCameraIsTakenAsItIs) {
  const auto scene = loadFile(withCamera({{"translation", {1, 2, 3}}}, kLens));
  ASSERT_TRUE(scene) << sentence(scene.error());
  ASSERT_EQ(scene->cameras.size(), 1U);
  const SceneCamera& camera = scene->cameras[0];
  EXPECT_EQ(camera.name, "eye");
  EXPECT_EQ(camera.fov_y_rad, 1.0);
  EXPECT_EQ(camera.near_m, 0.25);
  EXPECT_EQ(camera.far_m, 50.0);
  EXPECT_EQ(camera.view_from_world * glm::dvec4(1, 2, 1, 1), glm::dvec4(0, 0, -2, 1));
}

TEST(GltfCameras, TheScaleOfANodeDoesNotStretchTheView) {
  const auto scene = loadFile(withCamera({{"scale", {3, 5, 7}}, {"translation", {0, 0, 4}}}, kLens));
  ASSERT_TRUE(scene) << sentence(scene.error());
  EXPECT_EQ(scene->cameras[0].view_from_world * glm::dvec4(1, 1, 1, 1), glm::dvec4(1, 1, -3, 1));
}

TEST(GltfCameras, WithoutZfarTheWholeSceneIsInFront) {
  json root = withCamera({{"translation", {0, 0, 40}}}, {{"yfov", 1.0}, {"znear", 0.1}});
  const auto scene = loadFile(root);
  ASSERT_TRUE(scene) << sentence(scene.error());
  EXPECT_GT(scene->cameras[0].far_m, 40.0);
  EXPECT_LT(scene->cameras[0].far_m, 60.0);
}

TEST(GltfCameras, ASceneWithoutOneIsFramedWhole) {
  json root = triangleFile();
  setPositions(root, {-30, 5, 2, 40, 5, 2, 0, 60, -70});
  const auto scene = loadFile(root);
  ASSERT_TRUE(scene) << sentence(scene.error());
  EXPECT_TRUE(hasNote(*scene, "no camera"));
  for (const Size size : {Size{100, 100}, Size{160, 90}}) {
    const Camera camera = cameraFor(scene->cameras[0], size);
    for (const Vertex& vertex : scene->vertices) {
      const glm::dvec4 p_clip =
          camera.clip_from_view * camera.view_from_world * glm::dvec4(vertex.p_world, 1.0);
      EXPECT_LT(std::abs(p_clip.x), p_clip.w);
      EXPECT_LT(std::abs(p_clip.y), p_clip.w);
      EXPECT_GT(p_clip.z, 0.0);
      EXPECT_LT(p_clip.z, p_clip.w);
    }
  }
  // From above and from the front.
  const glm::dvec3 eye(glm::inverse(scene->cameras[0].view_from_world)[3]);
  EXPECT_GT(eye.y, 60.0);
  EXPECT_GT(eye.z, 2.0);
}

TEST(GltfCameras, ANamedOneComesFirst) {
  json root = withCamera({}, kLens);
  root["cameras"].push_back(
      {{"name", "other"}, {"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 1}}}});
  root["nodes"].push_back({{"camera", 1}});
  root["scenes"][0]["nodes"].push_back(2);
  const auto scene = loadFile(root, {.mirror_material = "", .camera_name = "other"});
  ASSERT_TRUE(scene) << sentence(scene.error());
  EXPECT_EQ(scene->cameras[0].name, "other");
  EXPECT_EQ(scene->cameras[1].name, "eye");
}

TEST(GltfCameras, AnUnknownNameIsRefusedWithTheNearest) {
  const std::string refusal =
      refusalOf(withCamera({}, kLens), {.mirror_material = "", .camera_name = "eyes"});
  EXPECT_NE(refusal.find("it has no camera 'eyes'; did you mean 'eye'?"), std::string::npos) << refusal;
}

TEST(GltfCameras, AnOrthographicOneBesideOthersIsNoted) {
  json root = withCamera({}, kLens);
  addOrthographic(root, "plan");
  const auto scene = loadFile(root);
  ASSERT_TRUE(scene) << sentence(scene.error());
  EXPECT_EQ(scene->cameras.size(), 1U);
  EXPECT_TRUE(hasNote(*scene, "orthographic cameras are not supported"));
}

TEST(GltfCameras, AnOrthographicOneAloneOrNamedIsRefused) {
  json root = triangleFile();
  addOrthographic(root, "plan");
  EXPECT_NE(refusalOf(root).find("orthographic cameras are not supported"), std::string::npos);
  root = withCamera({}, kLens);
  addOrthographic(root, "plan");
  const std::string refusal = refusalOf(root, {.mirror_material = "", .camera_name = "plan"});
  EXPECT_NE(refusal.find("the camera 'plan' is orthographic"), std::string::npos) << refusal;
}

TEST(GltfCameras, ImpossibleLensesAreRefusedByPlace) {
  const auto refusal = [](const json& lens) { return refusalOf(withCamera({}, lens)); };
  EXPECT_NE(refusal({{"yfov", 4}, {"znear", 1}}).find("cameras[0]: could not load the scene: yfov is 4"),
            std::string::npos);
  EXPECT_NE(refusal({{"yfov", 1}, {"znear", 0}}).find("cameras[0]: could not load the scene: znear is 0"),
            std::string::npos);
  EXPECT_NE(refusal({{"yfov", 1}, {"znear", 5}, {"zfar", 5}}).find("zfar is 5"), std::string::npos);
  EXPECT_NE(refusalOf(withCamera({{"scale", {1, 0, 1}}}, kLens)).find("leaves its camera no direction"),
            std::string::npos);
}

TEST(CameraFor, TakesTheAspectOfTheImage) {
  SceneCamera scene_camera;
  scene_camera.fov_y_rad = 2.0 * std::atan(0.5);
  const Camera camera = cameraFor(scene_camera, {400, 100});
  EXPECT_NEAR(camera.clip_from_view[0][0], 0.5, 1e-15);
  EXPECT_NEAR(camera.clip_from_view[1][1], 2.0, 1e-15);
  EXPECT_EQ(camera.size, (Size{400, 100}));
  EXPECT_EQ(camera.near_m, scene_camera.near_m);
  EXPECT_EQ(camera.far_m, scene_camera.far_m);
}

}  // namespace
}  // namespace ssrkit::test
