// The shadow map and the shadow pass over scenes whose shadows can be worked out by hand.
#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "frame/shadow_projection.h"
#include "shadow_scene_test.h"

namespace ssrkit {
namespace {

// Of the finest cascade that holds the point and its filter: the shader's choice, in double precision.
double texelAt(const ShadowProjection& fit, const glm::dvec3& p_world) {
  const glm::dvec3 p_light(fit.light_from_world * glm::dvec4(p_world, 1.0));
  for (const ShadowCascade& cascade : fit.cascades) {
    const glm::dvec2 px = (glm::dvec2(p_light) - cascade.origin_m) / cascade.texel_m;
    const glm::dvec2 to_edge = glm::min(px, static_cast<double>(kShadowSideTexels) - px);
    if (std::min(to_edge.x, to_edge.y) >= 2.0) {
      return cascade.texel_m;
    }
  }
  return 0.0;
}

}  // namespace

// A screen at z = -4, one metre high, stands on a floor at y = -1 and is lit from behind under 45 degrees:
// its upper edge throws its shadow's edge to z = -3. Unpitched cameras look at it, as m1's at its wall: one a
// metre over the floor, and one so near that the edge is many rows wide.
//
// Across the edge the share of the 3 x 3 texels that is lit grows in a line from 0 at -1.5 texels to 1 at
// +1.5, up to the half texel by which the map's own edge is off, in every row by the same.
TEST_P(ShadowTest, BeginsInItsRowOverAFloorWithinHalfATexel) {
  const glm::dvec3 way = lightFrom(45, 180);
  PlaneScene planes(way);
  planes.floor(-1.0, 12.0).quad({{-3, -1, -4}, {3, -1, -4}, {3, 0, -4}, {-3, 0, -4}}, {.double_sided = true});
  const auto check_from = [&](const glm::dvec3& eye, const std::string& shader) -> std::string {
    const Camera camera = shadowCamera(eye, 0.0, {64, 256});
    giveScene(planes.scene(), camera);
    const ShadowProjection fit = fitShadow(glm::normalize(way), worldBounds(planes.scene()), camera);
    const Image drawn = shadow(shader);
    double least_off = 1.0;
    double most_off = -1.0;
    for (int row = 129; row < 256; ++row) {
      const double dist = (1.0 + eye.y) * 2.0 * 128.0 / (row + 0.5 - 128.0);  // h f / Y
      if (dist > 3.9 + eye.z) {
        continue;
      }
      const double texel_m = texelAt(fit, {0, -1, eye.z - dist});
      const double past_edge_texels = (3.0 + eye.z - dist) * std::sin(std::numbers::pi / 4.0) / texel_m;
      const double expected = std::clamp(0.5 + past_edge_texels / 3.0, 0.0, 1.0);
      const double off = drawn.at(32, row) - expected;
      if (!(std::abs(off) < 0.5 / 3.0 + 0.01)) {
        return fmt::format("row {}: {}, expected {}, texel {} m", row, drawn.at(32, row), expected, texel_m);
      }
      if (std::abs(past_edge_texels) < 1.0) {
        least_off = std::min(least_off, off);
        most_off = std::max(most_off, off);
      }
    }
    return most_off - least_off < 0.02 ? "" : fmt::format("off by {} to {}", least_off, most_off);
  };
  const auto check = [&](const std::string& shader) {
    const std::string from_afar = check_from({0, 0, 0}, shader);
    return from_afar.empty() ? check_from({0, -0.9, -2.7}, shader) : from_afar;
  };
  holdsAndKills(check, "shadow.frag", {"shadow_texel_off_by_one"});
}

TEST_P(ShadowTest, ALitPlaneHasNoDarkPixelUnderAnyLight) {
  const Camera camera = shadowCamera({0, 1.7, 3}, -0.25, {160, 90});
  for (const double elevation : {2.0, 5.0, 12.0, 35.0, 65.0, 90.0}) {
    for (const double azimuth : {17.0, 90.0, 250.0}) {
      PlaneScene planes(lightFrom(elevation, azimuth));
      giveScene(planes.floor(0.0, 15.0).scene(), camera);
      EXPECT_EQ(allAre(shadow(), 1.0F), "") << elevation << " degrees, azimuth " << azimuth;
    }
  }
  PlaneScene planes(lightFrom(20, 17));
  giveScene(planes.floor(0.0, 15.0).scene(), camera);
  holdsAndKills([&](const std::string& shader) { return allAre(shadow(shader), 1.0F); }, "shadow.frag",
                {"shadow_point_receiver"});
}

TEST_P(ShadowTest, ASphereHasNoDarkPixelOnItsLitSide) {
  const Camera camera = shadowCamera({0, 0, 3}, 0.0, {160, 160});
  for (const double azimuth : {0.0, 30.0, 60.0}) {
    const glm::dvec3 way = lightFrom(40, azimuth);
    giveScene(faceted(way, {0, 0, 0}, 0.5).scene(), camera);
    const Image drawn = shadow();
    int dark = 0;
    int lit = 0;
    for (int y = 0; y < 160; ++y) {
      for (int x = 0; x < 160; ++x) {
        if (!isBackground(x, y) && -glm::dot(normalView(x, y), way) > 0.15) {
          ++lit;
          dark += drawn.at(x, y) < 1.0F;
        }
      }
    }
    EXPECT_EQ(dark, 0) << "of " << lit << ", azimuth " << azimuth;
    EXPECT_GT(lit, 1000);
  }
}

// A normal map bends the shading normal, not the surface: its slope against the light is the plane's. At the
// floor's own edge, where a neighbour is missing, the shading normal is all there is.
TEST_P(ShadowTest, ABentShadingNormalCastsNoShadow) {
  const Camera camera = shadowCamera({0, 1.7, 3}, -0.25, {160, 90});
  PlaneScene planes(lightFrom(42, 17));
  giveScene(planes.floor(0.0, 15.0).scene(), camera);
  Image bent = normal_view_;
  for (int y = 0; y < 90; ++y) {
    for (int x = 0; x < 160; ++x) {
      const glm::dvec3 normal =
          glm::normalize(normalView(x, y) + 0.4 * glm::dvec3(std::sin(0.7 * x), 0.0, std::cos(0.9 * y)));
      for (std::size_t i = 0; i < 3; ++i) {
        bent.at(x, y, i) = isBackground(x, y) ? 0.0F : static_cast<float>(normal[static_cast<int>(i)]);
      }
    }
  }
  give("normal_view", bent);
  const auto check = [&](const std::string& shader) -> std::string {
    const Image drawn = shadow(shader);
    for (int y = 1; y < 90; ++y) {
      for (int x = 0; x < 160; ++x) {
        if (!isBackground(x, y - 1) && drawn.at(x, y) != 1.0F) {
          return fmt::format("{} at ({}, {})", drawn.at(x, y), x, y);
        }
      }
    }
    return "";
  };
  holdsAndKills(check, "shadow.frag", {"shadow_shading_normal"});
}

// A box of 1 m stands on the floor, lit from ahead under 45 degrees: its shadow comes towards the camera. It
// begins at the foot, up to the bias of 0.53 / sin^2(45) texels along the light and half a texel of the map's
// own edge.
TEST_P(ShadowTest, ABoxIsNotDetachedFromItsShadow) {
  const Camera camera = shadowCamera({0, 0, 0}, 0.0, {64, 256});
  const glm::dvec3 way = lightFrom(45, 180);
  PlaneScene planes(way);
  planes.floor(-1.0, 12.0).box({-1, -1, -4}, {1, 0, -3});
  giveScene(planes.scene(), camera);
  const ShadowProjection fit = fitShadow(glm::normalize(way), worldBounds(planes.scene()), camera);
  const Image drawn = shadow();
  int seen = 0;
  for (int row = 129; row < 256; ++row) {
    const double dist = 2.0 * 128.0 / (row + 0.5 - 128.0);
    const double from_foot_texels =
        (3.0 - dist) * std::sin(std::numbers::pi / 4.0) / texelAt(fit, {0, -1, -dist});
    if (from_foot_texels > 3.0 && dist > 2.05) {
      EXPECT_EQ(drawn.at(32, row), 0.0F)
          << "row " << row << ", " << from_foot_texels << " texels from the foot";
      ++seen;
    }
  }
  EXPECT_GT(seen, 20);
}

INSTANTIATE_TEST_SUITE_P(Each, ShadowTest, testing::Values("gl-osmesa", "vk-lavapipe"), deviceTestName);

}  // namespace ssrkit
