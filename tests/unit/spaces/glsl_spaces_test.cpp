// The shaders' text of the spaces, compiled as C++ with GLM, against the C++ of the spaces: the two are kept
// equal.
#include <glm/glm.hpp>

#include <gtest/gtest.h>

#include <cmath>

#include "spaces/camera.h"

namespace glsl {
using glm::mat4;
using glm::sqrt;
using glm::vec2;
using glm::vec3;
using glm::vec4;
#include "ssr_ordered.glsl"
#include "ssr_spaces.glsl"
}  // namespace glsl

namespace ssrkit {
namespace {

Camera offCentreCamera() {
  Camera camera{.size = {320, 180},
                .clip_from_view = perspective(1.0, 320.0 / 180.0, 0.1, 100.0),
                .view_from_world = glm::dmat4(1.0),
                .near_m = 0.1,
                .far_m = 100.0};
  camera.clip_from_view[2][0] = 0.125;
  camera.clip_from_view[2][1] = -0.25;
  return camera;
}

glsl::PixelProjection shaderProjection(const Camera& camera) {
  const PixelProjection projection = pixelProjection(camera);
  return {glm::vec2(projection.px_scale), glm::vec2(projection.px_offset),
          1.0F / glm::vec2(projection.px_scale)};
}

TEST(GlslSpaces, ProjectAsTheMatrixDoes) {
  const Camera camera = offCentreCamera();
  const glm::vec3 p_view(0.7F, -0.4F, -3.0F);
  const glm::dvec4 p_clip = camera.clip_from_view * glm::dvec4(p_view, 1.0);
  const glm::vec2 p_px = glsl::position_view_to_px(p_view, shaderProjection(camera));
  EXPECT_NEAR(p_px.x, (0.5 + 0.5 * p_clip.x / p_clip.w) * 320.0, 1e-4);
  EXPECT_NEAR(p_px.y, (0.5 - 0.5 * p_clip.y / p_clip.w) * 180.0, 1e-4);
}

TEST(GlslSpaces, ProjectAClipPositionAsItsViewPosition) {
  const Camera camera = offCentreCamera();
  const glm::vec4 p_view(0.7F, -0.4F, -3.0F, 1.0F);
  const glm::vec4 p_clip = glsl::ordered_transform(glm::mat4(camera.clip_from_view), p_view);
  const glm::vec4 expected(camera.clip_from_view * glm::dvec4(p_view));
  EXPECT_LE(glm::length(p_clip - expected), 1e-6F);
  const glm::vec2 p_px = glsl::position_clip_to_px(p_clip, glm::vec2(320.0F, 180.0F));
  const glm::vec2 same_px = glsl::position_view_to_px(glm::vec3(p_view), shaderProjection(camera));
  EXPECT_NEAR(p_px.x, same_px.x, 1e-4);
  EXPECT_NEAR(p_px.y, same_px.y, 1e-4);
}

TEST(GlslSpaces, ReconstructWhatTheyProject) {
  const glsl::PixelProjection projection = shaderProjection(offCentreCamera());
  const glm::vec3 p_view = glsl::position_px_to_view(glm::vec2(17.5F, 93.5F), 4.0F, projection);
  EXPECT_EQ(p_view.z, -4.0F);
  const glm::vec2 p_px = glsl::position_view_to_px(p_view, projection);
  EXPECT_NEAR(p_px.x, 17.5, 1e-4);
  EXPECT_NEAR(p_px.y, 93.5, 1e-4);
}

TEST(GlslSpaces, PutTheUpperEdgeOfThePictureAtRowZero) {
  // NDC y = 1 is the upper edge; row 0 of the image is NDC y = -1 of the rasteriser.
  const glm::vec4 upper = glsl::rasterizer_from_clip(glm::vec4(0.0F, 2.0F, 0.5F, 2.0F));
  EXPECT_EQ(upper.y / upper.w, -1.0F);
  EXPECT_EQ(upper.z, 0.5F);
}

TEST(GlslOrdered, ReflectsALevelFloorByTurningOneSignOnly) {
  const glm::vec3 incident = glsl::ordered_normalize(glm::vec3(0.3F, -0.5F, -0.7F));
  const glm::vec3 reflected = glsl::ordered_reflect(incident, glm::vec3(0.0F, 1.0F, 0.0F));
  EXPECT_EQ(reflected.x, incident.x);
  EXPECT_EQ(reflected.y, -incident.y);
  EXPECT_EQ(reflected.z, incident.z);
}

TEST(GlslOrdered, NormalizesToLengthOne) {
  const glm::vec3 unit = glsl::ordered_normalize(glm::vec3(3.0F, -4.0F, 12.0F));
  EXPECT_FLOAT_EQ(unit.x, 3.0F / 13.0F);
  EXPECT_FLOAT_EQ(unit.y, -4.0F / 13.0F);
  EXPECT_FLOAT_EQ(unit.z, 12.0F / 13.0F);
}

}  // namespace
}  // namespace ssrkit
