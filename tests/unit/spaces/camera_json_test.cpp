#include "spaces/camera_json.h"

#include <gtest/gtest.h>

#include <string>

namespace ssrkit {
namespace {

Camera someCamera() {
  Camera camera{.size = {640, 360},
                .clip_from_view = perspective(1.0471975511965976, 16.0 / 9.0, 0.05, 1234.5),
                .view_from_world = glm::dmat4(1.0),
                .near_m = 0.05,
                .far_m = 1234.5};
  camera.view_from_world[3] = glm::dvec4(0.1, -2.0 / 3.0, 1e-17, 1.0);
  return camera;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(CameraJson, GoesThereAndBackBitForBit) {
  const Camera camera = someCamera();
  const auto read = cameraFromJson(toJson(camera), "camera.json");
  ASSERT_TRUE(read.has_value()) << sentence(read.error());
  EXPECT_EQ(read->size, camera.size);
  EXPECT_EQ(read->clip_from_view, camera.clip_from_view);
  EXPECT_EQ(read->view_from_world, camera.view_from_world);
  EXPECT_EQ(read->near_m, camera.near_m);
  EXPECT_EQ(read->far_m, camera.far_m);
}

TEST(CameraJson, KeepsThePreviousPlaceWhereThereIsOne) {
  Camera camera = someCamera();
  EXPECT_FALSE(cameraFromJson(toJson(camera), "camera.json")->previous_view_from_world.has_value());
  camera.previous_view_from_world = camera.view_from_world;
  (*camera.previous_view_from_world)[3].y = 0.8125;
  EXPECT_EQ(cameraFromJson(toJson(camera), "camera.json")->previous_view_from_world,
            camera.previous_view_from_world);
  const std::string spoilt = replaced(toJson(camera), "0.8125", "\"x\"");
  const auto read = cameraFromJson(spoilt, "camera.json");
  ASSERT_FALSE(read.has_value());
  EXPECT_NE(sentence(read.error()).find("row 1, column 3 of 'previous_view_from_world' is not a number"),
            std::string::npos)
      << sentence(read.error());
}

TEST(CameraJson, WritesMatricesRowByRow) {
  const std::string text = toJson(someCamera());
  // The translation stands at the ends of the rows.
  const std::size_t rows = text.find("\"view_from_world\"");
  const std::size_t first_end = text.find("0.1", rows);
  EXPECT_LT(first_end, text.find("-0.6666666666666666", rows));
}

// As docs/formats.md lists the keys, and no more.
TEST(CameraJson, NeedsNeitherSchemaNorVersion) {
  std::string text = replaced(toJson(someCamera()), "\"schema\": \"ssrkit.camera\",", "");
  text = replaced(text, "\"version\": 1,", "");
  const auto read = cameraFromJson(text, "camera.json");
  ASSERT_TRUE(read.has_value()) << sentence(read.error());
  EXPECT_EQ(read->clip_from_view, someCamera().clip_from_view);
}

Camera scaledCamera() {
  Camera camera = someCamera();
  camera.view_from_world[0] *= 2.0;
  return camera;
}

struct BadJson {
  const char* name;
  std::string text;
  const char* says;
};

class CameraJsonRefuses : public testing::TestWithParam<BadJson> {};

TEST_P(CameraJsonRefuses, WithTheFileAndTheReason) {
  const auto read = cameraFromJson(GetParam().text, "folder/camera.json");
  ASSERT_FALSE(read.has_value());
  const std::string text = sentence(read.error());
  EXPECT_EQ(text.find("folder/camera.json"), 0U) << text;
  EXPECT_NE(text.find(GetParam().says), std::string::npos) << text;
  EXPECT_EQ(exitCode(read.error()), 2);
}

INSTANTIATE_TEST_SUITE_P(
    Each, CameraJsonRefuses,
    testing::Values(
        BadJson{"empty", "", "parse error"}, BadJson{"no_json", "{\"size\": ", "parse error"},
        BadJson{"an_array", "[]", "not a JSON object"},
        BadJson{"other_schema", replaced(toJson(someCamera()), "ssrkit.camera", "x"), "'schema' is not"},
        BadJson{"later_version", replaced(toJson(someCamera()), "\"version\": 1", "\"version\": 2"),
                "'version' is not 1"},
        BadJson{"version_in_quotes", replaced(toJson(someCamera()), "\"version\": 1", "\"version\": \"1\""),
                "'version' is not 1"},
        BadJson{"scaled_camera", toJson(scaledCamera()), "view_from_world is not a rotation"},
        BadJson{"size_of_one", replaced(toJson(someCamera()), "640,\n    360", "640"), "'size'"},
        BadJson{"negative_size", replaced(toJson(someCamera()), "640", "-640"), "the size 0x360"},
        BadJson{"huge_size", replaced(toJson(someCamera()), "640", "99999999999"), "the size 0x360"},
        BadJson{"text_in_matrix", replaced(toJson(someCamera()), "-0.6666666666666666", "\"a\""),
                "not a number"},
        BadJson{"no_near", replaced(toJson(someCamera()), "\"near_m\"", "\"near\""), "'near_m'"},
        BadJson{"negative_near", replaced(toJson(someCamera()), "\"near_m\": 0.05", "\"near_m\": -1"),
                "0 < near_m"}),
    [](const auto& parameter) { return std::string(parameter.param.name); });

}  // namespace
}  // namespace ssrkit
