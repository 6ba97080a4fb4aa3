// The passes that pack normals and depths and read them back, against bounds worked out by hand
// (tests/unit/spaces/glsl_normal_encoding_test.cpp) and the projection in double precision.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "frame/gbuffer_source.h"
#include "infinity.h"
#include "pass_test.h"

namespace ssrkit {
namespace {

constexpr Size kPackedSize{192, 96};
constexpr double kHalfQuantum = 0.5 / 32767.0;

// All directions, a row an elevation; the first row is background. A is a clearance of its own.
Image directions() {
  return imageOf(kPackedSize, [](int x, int y) -> std::array<double, 4> {
    if (y == 0) {
      return {0, 0, 0, 0.25};
    }
    const double theta = std::numbers::pi * y / (kPackedSize.height - 1);
    const double phi = 2.0 * std::numbers::pi * (x + 0.3) / kPackedSize.width;
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta), 0.01 * x};
  });
}

glm::dvec3 normalAt(const Image& image, int x, int y) {
  return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
}

class PackedTest : public PassTest {
 protected:
  void SetUp() override {
    PassTest::SetUp();
    given_directions_ = directions();
    give("normal_view", given_directions_);
  }

  [[nodiscard]] Image octahedral(const std::string& pack, const std::string& unpack) {
    drawGiven(pack, kPackedSize, Format::kRg16i, "normal_octahedral");
    return draw(unpack, kPackedSize);
  }

  [[nodiscard]] Image xySign(const std::string& unpack) {
    drawGiven("normal_pack_xy_sign.frag", kPackedSize, Format::kRgba16ui, "normal_xy_sign");
    return draw(unpack, kPackedSize);
  }

  // Every direction within `bound` radians of what was packed; background and clearance as they were.
  [[nodiscard]] std::string comesBack(const Image& back, double bound) const {
    for (int y = 0; y < kPackedSize.height; ++y) {
      for (int x = 0; x < kPackedSize.width; ++x) {
        const glm::dvec3 given = normalAt(given_directions_, x, y);
        const glm::dvec3 found = normalAt(back, x, y);
        const double angle = std::atan2(glm::length(glm::cross(given, found)), glm::dot(given, found));
        if (!(angle <= bound) || (y == 0) != (glm::length(found) == 0.0) ||
            back.at(x, y, 3) != given_directions_.at(x, y, 3)) {
          return fmt::format("({}, {}) of texel ({}, {}) is {} rad off", found.x, found.y, x, y, angle);
        }
      }
    }
    return "";
  }

  Image given_directions_;
};

TEST_P(PackedTest, OctahedralNormalsComeBackWithinTheirBound) {
  const double bound = std::sqrt(18.0) * kHalfQuantum + 4e-7;
  holdsAndKills(
      [&](const std::string& pack) {
        return comesBack(octahedral(pack, "normal_unpack_octahedral.frag"), bound);
      },
      "normal_pack_octahedral.frag", {"normal_truncated"});
}

TEST_P(PackedTest, NormalsOfXyAndSignComeBackWithinTheirBound) {
  const double bound = std::acos(1.0 - std::numbers::sqrt2 * kHalfQuantum) + 1e-5;
  holdsAndKills([&](const std::string& unpack) { return comesBack(xySign(unpack), bound); },
                "normal_unpack_xy_sign.frag", {"normal_sign_lost"});
}

TEST_P(PackedTest, WhatIsReadIsAUnitVector) {
  const auto unit = [](const Image& back) -> std::string {
    for (int y = 1; y < kPackedSize.height; ++y) {
      for (int x = 0; x < kPackedSize.width; ++x) {
        const double length = glm::length(normalAt(back, x, y));
        if (!(std::abs(length - 1.0) <= 2e-7)) {
          return fmt::format("length {} at ({}, {})", length, x, y);
        }
      }
    }
    return "";
  };
  EXPECT_EQ(unit(xySign("normal_unpack_xy_sign.frag")), "");
  holdsAndKills(
      [&](const std::string& unpack) { return unit(octahedral("normal_pack_octahedral.frag", unpack)); },
      "normal_unpack_octahedral.frag", {"normal_not_normalised"});
}

// The stored depth d is rounded to 32 bits, 2^-25 off near 1, and so are P22 and P23: with dist = P23 / (d +
// P22), a change of e in d + P22 is one of e * dist / |P23| of the distance. Two roundings of 2^-25 and one
// of P22 by 2^-24.
TEST_P(PackedTest, StoredDepthsComeBackAsMetres) {
  const Camera camera{.size = kPackedSize,
                      .clip_from_view = perspective(1.0, 2.0, 0.1, 100.0),
                      .view_from_world = glm::dmat4(1.0),
                      .near_m = 0.1,
                      .far_m = 100.0};
  const auto distOf = [](int x, int y) {
    return 0.1 *
           std::pow(1000.0, (x + kPackedSize.width * y + 0.5) / (kPackedSize.width * kPackedSize.height));
  };
  const Image stored = imageOf(
      kPackedSize,
      [&](int x, int y) -> std::array<double, 4> {
        return {x == 7 ? 1.0 : depthWindowFromDistView(camera, distOf(x, y)), 0, 0, 0};
      },
      1);
  begin();
  setCameraUniforms(values_, camera);
  give("depth_window", stored, Format::kR32f);
  const auto check = [&](const std::string& shader) -> std::string {
    const Image back = draw(shader, kPackedSize, Format::kR32f);
    for (int y = 0; y < kPackedSize.height; ++y) {
      for (int x = 0; x < kPackedSize.width; ++x) {
        const double dist = distOf(x, y);
        const double bound = std::exp2(-23.0) * dist / 0.1 + std::exp2(-22.0);
        const bool holds =
            x == 7 ? back.at(x, y) == kInfinity : std::abs(back.at(x, y) / dist - 1.0) <= bound;
        if (!holds) {
          return fmt::format("{} m read as {}", dist, back.at(x, y));
        }
      }
    }
    return "";
  };
  holdsAndKills(check, "dist_from_window.frag", {"depth_as_ndc"});
}

INSTANTIATE_TEST_SUITE_P(Each, PackedTest, testing::Values("gl-osmesa", "vk-lavapipe"), deviceTestName);

}  // namespace
}  // namespace ssrkit
