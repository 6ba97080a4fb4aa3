#include "spaces/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <string>

namespace ssrkit {
namespace {

Camera squareCamera() {
  // f = 2, a = 1: the canonical camera of the closed forms.
  return {.size = {256, 256},
          .clip_from_view = perspective(2.0 * std::atan(0.5), 1.0, 0.1, 100.0),
          .view_from_world = glm::dmat4(1.0),
          .near_m = 0.1,
          .far_m = 100.0};
}

TEST(PixelProjection, PutsTheFootOfTheWallOfM1OnTheEdgeBetweenRows159And160) {
  const PixelProjection projection = pixelProjection(squareCamera());
  const glm::dvec2 p_px = projection.px_scale * glm::dvec2(0.0, -1.0 / 8.0) + projection.px_offset;
  EXPECT_DOUBLE_EQ(p_px.x, 128.0);
  EXPECT_DOUBLE_EQ(p_px.y, 160.0);
}

TEST(PixelProjection, GrowsDownAndRight) {
  const PixelProjection projection = pixelProjection(squareCamera());
  EXPECT_GT(projection.px_scale.x, 0.0);
  EXPECT_LT(projection.px_scale.y, 0.0);
}

TEST(PixelProjection, AgreesWithTheMatrixForAnOffCentreCamera) {
  Camera camera = squareCamera();
  camera.size = {320, 180};
  camera.clip_from_view[2][0] = 0.125;
  camera.clip_from_view[2][1] = -0.25;
  const glm::dvec4 p_view(0.7, -0.4, -3.0, 1.0);
  const glm::dvec4 p_clip = camera.clip_from_view * p_view;
  const glm::dvec2 p_ndc = glm::dvec2(p_clip) / p_clip.w;
  const PixelProjection projection = pixelProjection(camera);
  const glm::dvec2 p_px = projection.px_scale * (glm::dvec2(p_view) / 3.0) + projection.px_offset;
  EXPECT_NEAR(p_px.x, (0.5 + 0.5 * p_ndc.x) * 320.0, 1e-12);
  EXPECT_NEAR(p_px.y, (0.5 - 0.5 * p_ndc.y) * 180.0, 1e-12);
}

TEST(Perspective, MapsTheNearPlaneToZeroAndTheFarPlaneToOne) {
  const Camera camera = squareCamera();
  EXPECT_NEAR(depthWindowFromDistView(camera, 0.1), 0.0, 1e-15);
  EXPECT_NEAR(depthWindowFromDistView(camera, 100.0), 1.0, 1e-15);
}

TEST(Perspective, StoresTheDepthThatTheFormulaGives) {
  // d = far (z - near) / (z (far - near))
  EXPECT_NEAR(depthWindowFromDistView(squareCamera(), 10.0), 100.0 * 9.9 / (10.0 * 99.9), 1e-15);
}

struct BadCamera {
  const char* name;
  void (*spoil)(Camera&);
  const char* says;
};

class ValidateCamera : public testing::TestWithParam<BadCamera> {};

TEST_P(ValidateCamera, RefusesWithASentence) {
  Camera camera = squareCamera();
  GetParam().spoil(camera);
  const auto valid = validate(camera, "read the camera");
  ASSERT_FALSE(valid.has_value());
  EXPECT_NE(sentence(valid.error()).find(GetParam().says), std::string::npos) << sentence(valid.error());
}

INSTANTIATE_TEST_SUITE_P(
    Each, ValidateCamera,
    testing::Values(
        BadCamera{"no_width", [](Camera& c) { c.size.width = 0; }, "the size 0x256"},
        BadCamera{"too_tall", [](Camera& c) { c.size.height = 20000; }, "outside 1x1 to 16384x16384"},
        BadCamera{"nan", [](Camera& c) { c.clip_from_view[0][0] = std::nan(""); }, "not finite"},
        BadCamera{"inf", [](Camera& c) { c.view_from_world[3][0] = std::numeric_limits<double>::infinity(); },
                  "not finite"},
        BadCamera{"orthographic",
                  [](Camera& c) {
                    c.clip_from_view[2][3] = 0.0;
                    c.clip_from_view[3][3] = 1.0;
                  },
                  "orthographic cameras are not supported"},
        BadCamera{"singular", [](Camera& c) { c.clip_from_view[1][1] = 0.0; }, "clip_from_view is singular"},
        BadCamera{"no_depth", [](Camera& c) { c.clip_from_view[3][2] = 0.0; }, "clip_from_view is singular"},
        BadCamera{"flat", [](Camera& c) { c.view_from_world[1] = glm::dvec4(0.0); },
                  "view_from_world is singular"},
        BadCamera{"near_zero", [](Camera& c) { c.near_m = 0.0; }, "0 < near_m < far_m"},
        BadCamera{"far_before_near", [](Camera& c) { c.far_m = 0.05; }, "0 < near_m < far_m"}),
    [](const auto& parameter) { return std::string(parameter.param.name); });

// A turn about an axis that is none of the world's, with a shift.
glm::dmat4 someView() {
  return glm::translate(glm::rotate(glm::dmat4(1.0), 0.7, glm::normalize(glm::dvec3(1.0, 2.0, -0.5))),
                        glm::dvec3(10.0, -3.0, 250.0));
}

glm::dmat4 rounded(glm::dmat4 matrix, double unit) {
  for (int column = 0; column < 4; ++column) {
    matrix[column] = unit * glm::round(matrix[column] / unit);
  }
  return matrix;
}

std::string rigidProblem(const glm::dmat4& view_from_world) {
  Camera camera = squareCamera();
  camera.view_from_world = view_from_world;
  const auto rigid = validateRigid(camera, "read the camera");
  return rigid ? "" : sentence(rigid.error());
}

TEST(ValidateRigid, AcceptsTurnsAndShiftsOfFewDigits) {
  EXPECT_EQ(rigidProblem(someView()), "");
  EXPECT_EQ(rigidProblem(glm::dmat4(glm::mat4(someView()))), "") << "32-bit numbers";
  EXPECT_EQ(rigidProblem(rounded(someView(), 1e-4)), "") << "four decimals";
  EXPECT_EQ(rigidProblem(glm::scale(someView(), {1.0, 1.0, -1.0})), "") << "a left-handed world";
}

TEST(ValidateRigid, RefusesScaleShearAndProjection) {
  const char* const kNotRigid = "view_from_world is not a rotation with a shift";
  for (const glm::dmat4& change : {glm::scale(glm::dmat4(1.0), {2.0, 2.0, 2.0}),
                                   glm::scale(glm::dmat4(1.0), {1.0, 1.0, 1.01}), glm::dmat4(0.0)}) {
    EXPECT_NE(rigidProblem(change * someView()).find(kNotRigid), std::string::npos);
  }
  glm::dmat4 sheared = someView();
  sheared[0] += 0.1 * sheared[1];
  EXPECT_NE(rigidProblem(sheared).find(kNotRigid), std::string::npos);
  glm::dmat4 transposed = glm::transpose(someView());  // column-major numbers read as rows
  EXPECT_NE(rigidProblem(transposed).find("last row must be 0 0 0 1"), std::string::npos);
  Camera camera = squareCamera();
  camera.previous_view_from_world = glm::dmat4(2.0);
  EXPECT_FALSE(validateRigid(camera, "read").has_value());
}

TEST(ValidateCamera, AcceptsTheCanonicalOne) {
  EXPECT_TRUE(validate(squareCamera(), "read").has_value());
}

}  // namespace
}  // namespace ssrkit
