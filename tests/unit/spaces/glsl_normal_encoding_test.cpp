// The shaders' own text of the normal encodings, compiled as C++ with GLM, against bounds worked out by hand:
// half a quantum of a stored coordinate, h = 1 / 65534, times how fast the direction turns with it.
#include <glm/glm.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace normal_encoding {  // of this file alone: other tests compile the same includes
using glm::abs;
using glm::clamp;
using glm::floor;
using glm::ivec2;
using glm::mat4;
using glm::max;
using glm::sqrt;
using glm::vec2;
using glm::vec3;
using glm::vec4;
#include "normal_encoding.glsl"
}  // namespace normal_encoding

namespace ssrkit {
namespace {

constexpr double kHalfQuantum = 0.5 / 32767.0;
constexpr double kSinglePrecision = 4e-7;  // rad: a few roundings of the encoding's own arithmetic

double angle(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// Directions a twentieth of a degree apart at the octahedron's edges and z = 0, half a degree apart
// elsewhere.
std::vector<glm::dvec3> directions() {
  std::vector<glm::dvec3> list;
  for (int i = 0; i <= 3600; ++i) {
    const bool is_near_equator = std::abs(i - 1800) <= 40;
    if (i % 10 != 0 && !is_near_equator) {
      continue;
    }
    const double theta = std::numbers::pi * i / 3600.0;
    for (int j = 0; j < 7200; j += is_near_equator ? 3 : 10) {
      const double phi = 2.0 * std::numbers::pi * j / 7200.0;
      list.emplace_back(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
    }
  }
  return list;
}

glm::vec3 throughOctahedral(const glm::vec3& normal) {
  return normal_encoding::normal_from_octahedral(normal_encoding::octahedral_from_normal(normal));
}

glm::vec3 throughXySign(const glm::vec3& normal) {
  return normal_encoding::normal_from_xy_sign(normal_encoding::xy_from_normal(normal), normal.z < 0.0F);
}

double largestAngle(const std::function<glm::vec3(const glm::vec3&)>& through) {
  double largest = 0.0;
  for (const glm::dvec3& direction : directions()) {
    const glm::vec3 back = through(glm::vec3(direction));
    EXPECT_NEAR(glm::length(back), 1.0F, 2e-7F);
    largest = std::max(largest, angle(glm::dvec3(glm::vec3(direction)), glm::dvec3(back)));
  }
  return largest;
}

// On a face of the octahedron, at 1 / sqrt 3 from the origin in its middle, a step of (h, h) in x and y is
// one of (h, h, -2h): sqrt(6) h long, seen from the origin under sqrt(18) h.
TEST(GlslNormalEncoding, OctahedralTurnsADirectionByItsBoundAndNotMuchLess) {
  const double bound = std::sqrt(18.0) * kHalfQuantum;
  const double largest = largestAngle(throughOctahedral);
  EXPECT_LE(largest, bound + kSinglePrecision);
  EXPECT_GE(largest, 0.9 * bound);
  EXPECT_NEAR(bound * 180.0 / std::numbers::pi, 0.0037, 5e-5);
}

// x and y off by h each move a point of the unit circle inwards by sqrt(2) h: z becomes sin(acos(1 - sqrt(2)
// h)).
TEST(GlslNormalEncoding, XyAndSignTurnADirectionByItsBoundAndNotMuchLess) {
  const double bound = std::acos(1.0 - std::numbers::sqrt2 * kHalfQuantum);
  const double largest = largestAngle(throughXySign);
  EXPECT_LE(largest, bound + 1e-5);
  EXPECT_GE(largest, 0.9 * bound);
  EXPECT_NEAR(bound * 180.0 / std::numbers::pi, 0.376, 5e-4);
}

TEST(GlslNormalEncoding, KeepAxesExactlyWithZerosOfEitherSign) {
  for (const float zero : {0.0F, -0.0F}) {
    for (const float one : {1.0F, -1.0F}) {
      for (const glm::vec3& axis :
           {glm::vec3(one, zero, -zero), glm::vec3(-zero, one, zero), glm::vec3(zero, zero, one)}) {
        EXPECT_EQ(throughOctahedral(axis), axis);
        EXPECT_EQ(throughXySign(axis), axis);
      }
    }
  }
}

TEST(GlslNormalEncoding, KeepTheSignOfEveryComponentThatIsOverAQuantum) {
  for (const glm::dvec3& direction : directions()) {
    const glm::vec3 normal(direction);
    for (const glm::vec3& back : {throughOctahedral(normal), throughXySign(normal)}) {
      for (int i = 0; i < 3; ++i) {
        if (std::abs(normal[i]) > 2.0F / 32767.0F) {
          ASSERT_GE(normal[i] * back[i], 0.0F) << normal.x << ", " << normal.y << ", " << normal.z;
        }
      }
    }
  }
}

TEST(GlslNormalEncoding, RoundToTheNearestInteger) {
  EXPECT_EQ(normal_encoding::snorm16_from_float({0.49F / 32767.0F, -0.49F / 32767.0F}), glm::ivec2(0, 0));
  EXPECT_EQ(normal_encoding::snorm16_from_float({0.51F / 32767.0F, -0.51F / 32767.0F}), glm::ivec2(1, -1));
  EXPECT_EQ(normal_encoding::snorm16_from_float({1.5F, -1.5F}), glm::ivec2(32767, -32767));
}

}  // namespace
}  // namespace ssrkit
