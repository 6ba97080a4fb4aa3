// The shadow map and the shadow pass over scenes whose shadows can be worked out by hand.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "frame/gbuffer_source.h"
#include "frame/shadow_map.h"
#include "frame/shadow_projection.h"
#include "pass_test.h"
#include "plane_scene.h"

namespace ssrkit {
namespace {

constexpr double kHalfPi = std::numbers::pi / 2.0;

Camera cameraAt(const glm::dvec3& position, double pitch_rad, Size size) {
  Camera camera{.size = size,
                .clip_from_view = perspective(2.0 * std::atan(0.5),
                                              static_cast<double>(size.width) / size.height, 0.1, 100.0),
                .view_from_world = glm::dmat4(1.0),
                .near_m = 0.1,
                .far_m = 100.0};
  const double c = std::cos(pitch_rad);
  const double s = std::sin(pitch_rad);
  const glm::dmat3 world_from_view(glm::dvec3(1, 0, 0), glm::dvec3(0, c, s), glm::dvec3(0, -s, c));
  const glm::dmat3 rotation = glm::transpose(world_from_view);
  camera.view_from_world = glm::dmat4(rotation);
  camera.view_from_world[3] = glm::dvec4(-(rotation * position), 1.0);
  return camera;
}

// The way of light that comes from `elevation` over the horizon; azimuth 0 travels along -z.
glm::dvec3 lightFrom(double elevation_deg, double azimuth_deg) {
  const double e = elevation_deg * std::numbers::pi / 180.0;
  const double a = azimuth_deg * std::numbers::pi / 180.0;
  return {-std::cos(e) * std::sin(a), -std::sin(e), -std::cos(e) * std::cos(a)};
}

class ShadowTest : public PassTest {
 protected:
  // Draws the G-buffer and the shadow map, and gives them to the pass.
  void giveScene(const Scene& scene, const Camera& camera) {
    begin();
    size_ = camera.size;
    setCameraUniforms(values_, camera);
    setLightUniforms(values_, scene, camera.view_from_world);
    const int cascade_count = setShadowUniforms(values_, scene, camera);
    auto resources = uploadScene(*device_, scene);
    ASSERT_TRUE(resources.has_value());
    if (programs_ == nullptr) {
      programs_ = std::make_unique<Programs>(*device_, target_);
    }
    const CompileSettings settings{.shader_root = std::string(SSRKIT_SOURCE_DIR) + "/shaders"};
    const auto gbuffer = programs_->get(gbufferPass(), settings);
    const auto map = shadowMapPrograms(*programs_, settings);
    ASSERT_TRUE(gbuffer.has_value() && map.has_value());
    FrameImages images(*device_, camera.size);
    ASSERT_TRUE(drawGbuffer(*device_, **gbuffer, scene, *resources, images, values_).has_value());
    const auto mapped = drawShadowMap(*device_, *map, cascade_count, scene, *resources, images, values_);
    ASSERT_TRUE(mapped.has_value()) << sentence(mapped.error());
    dist_view_ = *readImage(*device_, *images.find("dist_view"), {"Z"});
    normal_view_ = *readImage(*device_, *images.find("normal_view"), {"R", "G", "B", "A"});
    give("dist_view", dist_view_, Format::kR32f);
    give("normal_view", normal_view_);
    give("shadow_map", *readImage(*device_, *images.find("shadow_map"), {"Z"}), Format::kR32f);
  }

  [[nodiscard]] Image shadow(const std::string& shader = "shadow.frag") {
    return PassTest::draw(shader, size_, Format::kR32f);
  }

  [[nodiscard]] bool isBackground(int x, int y) const { return std::isinf(dist_view_.at(x, y)); }
  [[nodiscard]] glm::dvec3 normalView(int x, int y) const {
    return {normal_view_.at(x, y, 0), normal_view_.at(x, y, 1), normal_view_.at(x, y, 2)};
  }

  Size size_;
  Image dist_view_;
  Image normal_view_;

 private:
  std::unique_ptr<Programs> programs_;
};

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

// "" when every pixel has the value, else how many have not.
std::string allAre(const Image& shadow, float value) {
  const auto count = std::ranges::count_if(shadow.data, [&](float lit) { return lit != value; });
  return count == 0 ? "" : fmt::format("{} of {} pixels are not {}", count, shadow.data.size(), value);
}

// As m1: an unpitched camera one metre over a floor. A screen four metres ahead, one metre high, is lit from
// behind under 45 degrees: its upper edge, at the camera's height, throws its shadow's edge to three metres.
//
// Across the edge the share of the 3 x 3 texels that is lit grows in a line from 0 at -1.5 texels to 1 at
// +1.5, up to the half texel by which the map's own edge is off.
TEST_P(ShadowTest, BeginsInItsRowOverAFloorWithinHalfATexel) {
  const Camera camera = cameraAt({0, 0, 0}, 0.0, {64, 256});
  const glm::dvec3 way = lightFrom(45, 180);
  PlaneScene planes(way);
  planes.floor(-1.0, 12.0).quad({{-3, -1, -4}, {3, -1, -4}, {3, 0, -4}, {-3, 0, -4}}, {.double_sided = true});
  giveScene(planes.scene(), camera);
  const ShadowProjection fit = fitShadow(glm::normalize(way), worldBounds(planes.scene()), camera);
  const auto check = [&](const std::string& shader) -> std::string {
    const Image drawn = shadow(shader);
    for (int row = 129; row < 256; ++row) {
      const double dist = 2.0 * 128.0 / (row + 0.5 - 128.0);  // f h / Y
      if (dist > 3.9) {
        continue;
      }
      const double texel_m = texelAt(fit, {0, -1, -dist});
      const double past_edge_texels = (3.0 - dist) * std::sin(std::numbers::pi / 4.0) / texel_m;
      const double expected = std::clamp(0.5 + past_edge_texels / 3.0, 0.0, 1.0);
      if (!(std::abs(drawn.at(32, row) - expected) < 0.5 / 3.0 + 0.01)) {
        return fmt::format("row {}: {}, expected {}, texel {} m", row, drawn.at(32, row), expected, texel_m);
      }
    }
    return "";
  };
  holdsAndKills(check, "shadow.frag", {"shadow_texel_off_by_one"});
}

TEST_P(ShadowTest, ALitPlaneHasNoDarkPixelUnderAnyLight) {
  const Camera camera = cameraAt({0, 1.7, 3}, -0.25, {160, 90});
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
  const Camera camera = cameraAt({0, 0, 3}, 0.0, {160, 160});
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
  const Camera camera = cameraAt({0, 1.7, 3}, -0.25, {160, 90});
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
  const Camera camera = cameraAt({0, 0, 0}, 0.0, {64, 256});
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

TEST_P(ShadowTest, LightAlongAPlaneAndWithinADegreeOfItGivesZero) {
  const Camera camera = cameraAt({0, 1.7, 3}, -0.25, {97, 53});
  for (const double elevation : {0.0, 0.5, 1.0, -10.0}) {
    PlaneScene planes(lightFrom(elevation, 20));
    giveScene(planes.floor(0.0, 15.0).scene(), camera);
    const Image drawn = shadow();
    for (int y = 0; y < 53; ++y) {
      for (int x = 0; x < 97; ++x) {
        ASSERT_EQ(drawn.at(x, y), isBackground(x, y) ? 1.0F : 0.0F) << x << ", " << y << " at " << elevation;
      }
    }
  }
}

TEST_P(ShadowTest, TrianglesWithoutAreaAndNormalsWithoutLengthCastNothing) {
  const Camera camera = cameraAt({0, 1.7, 3}, -0.25, {97, 53});
  PlaneScene planes(lightFrom(50, 20));
  planes.floor(0.0, 15.0);
  planes.triangle({-1, 1, 0}, {1, 1, 0}, {1, 1, 0}, {0, 1, 0}, {.double_sided = true});
  planes.triangle({0, 1, -1}, {0, 1, -1}, {0, 1, -1}, {0, 0, 0}, {.double_sided = true});
  giveScene(planes.scene(), camera);
  EXPECT_EQ(allAre(shadow(), 1.0F), "");
}

TEST_P(ShadowTest, WhatCastsIsWhatTheLightWouldSee) {
  const Camera camera = cameraAt({0, 1.7, 3}, -0.25, {97, 53});
  const Quad facing_up{{-20, 3, 20}, {20, 3, 20}, {20, 3, -20}, {-20, 3, -20}};
  const Quad facing_down{{-20, 3, -20}, {20, 3, -20}, {20, 3, 20}, {-20, 3, 20}};
  Material cut{.alpha_mode = AlphaMode::kMask};
  cut.base_colour.a = 0.25F;
  const Material cut_by_texture{.alpha_mode = AlphaMode::kMask, .base_colour_texture = 0};
  struct Case {
    Quad quad;
    Material material;
    bool casts;
  };
  for (const Case& cover : {Case{facing_up, {}, true}, Case{facing_down, {}, false},
                            Case{facing_down, {.double_sided = true}, true}, Case{facing_up, cut, false},
                            Case{facing_up, cut_by_texture, false}}) {
    PlaneScene planes(lightFrom(60, 20));
    planes.floor(0.0, 15.0).quad(cover.quad, cover.material);
    planes.scene().textures = {{.name = "hole", .size = {1, 1}, .rgba = {255, 255, 255, 0}}};
    giveScene(planes.scene(), camera);
    const Image drawn = shadow();
    EXPECT_EQ(drawn.at(48, 40), cover.casts ? 0.0F : 1.0F);
    EXPECT_EQ(drawn.at(20, 30), cover.casts ? 0.0F : 1.0F);
  }
}

TEST_P(ShadowTest, WithoutADirectionalLightNothingIsInShadow) {
  const Camera camera = cameraAt({0, 1.7, 3}, -0.25, {33, 17});
  PlaneScene planes(lightFrom(60, 20));
  planes.floor(0.0, 15.0).box({-2, 1, -2}, {2, 2, 2});
  planes.scene().directional_lights.clear();
  giveScene(planes.scene(), camera);
  EXPECT_EQ(allAre(shadow(), 1.0F), "");
}

TEST_P(ShadowTest, ImagesOfAnySizeAreDrawn) {
  for (const Size size : {Size{1, 1}, {3, 1}, {1, 5}, {7, 3}}) {
    PlaneScene planes(lightFrom(60, 20));
    giveScene(planes.floor(0.0, 40.0).scene(), cameraAt({0, 1.7, 3}, -kHalfPi / 2.0, size));
    EXPECT_EQ(allAre(shadow(), 1.0F), "") << size.width << " x " << size.height;
  }
}

INSTANTIATE_TEST_SUITE_P(Each, ShadowTest, testing::Values("gl-osmesa", "vk-lavapipe"), deviceTestName);

}  // namespace
}  // namespace ssrkit
