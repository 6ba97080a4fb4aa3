#include "scene/tangents.h"

#include <gtest/gtest.h>

#include <array>

namespace ssrkit {
namespace {

const std::array<glm::vec3, 3> kPositions{glm::vec3(0, 0, 0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)};
const std::array<glm::vec3, 3> kNormals{glm::vec3(0, 0, 1), glm::vec3(0, 0, 1), glm::vec3(0, 0, 1)};
const std::array<std::uint32_t, 3> kTriangle{0, 1, 2};

TEST(Tangents, PointAlongUAndTheBitangentUpInTheImage) {
  // An upright picture: u to the right, v downwards. Up in the image is +y, and cross(normal, tangent) is +y
  // too.
  const std::array<glm::vec2, 3> uvs{glm::vec2(0, 1), glm::vec2(1, 1), glm::vec2(0, 0)};
  for (const glm::vec4& tangent : tangentsFromUv(kPositions, kNormals, uvs, kTriangle)) {
    EXPECT_EQ(tangent, glm::vec4(1, 0, 0, 1));
  }
}

TEST(Tangents, AMirroredPictureHasTheOtherHandedness) {
  const std::array<glm::vec2, 3> uvs{glm::vec2(1, 1), glm::vec2(0, 1), glm::vec2(1, 0)};
  for (const glm::vec4& tangent : tangentsFromUv(kPositions, kNormals, uvs, kTriangle)) {
    EXPECT_EQ(tangent, glm::vec4(-1, 0, 0, -1));
  }
}

TEST(Tangents, ArePerpendicularToTheNormalWithoutUvs) {
  const std::array<glm::vec2, 3> uvs{};
  for (const glm::vec4& tangent : tangentsFromUv(kPositions, kNormals, uvs, kTriangle)) {
    EXPECT_EQ(glm::dot(glm::vec3(tangent), glm::vec3(0, 0, 1)), 0.0F);
    EXPECT_FLOAT_EQ(glm::length(glm::vec3(tangent)), 1.0F);
  }
}

}  // namespace
}  // namespace ssrkit
