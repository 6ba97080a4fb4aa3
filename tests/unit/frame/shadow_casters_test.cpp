// What casts a shadow and what does not, and what is said of scenes that give nothing to compare.
#include <numbers>

#include "shadow_scene_test.h"

namespace ssrkit {

TEST_P(ShadowTest, LightAlongAPlaneAndWithinADegreeOfItGivesZero) {
  const Camera camera = shadowCamera({0, 1.7, 3}, -0.25, {97, 53});
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
  const Camera camera = shadowCamera({0, 1.7, 3}, -0.25, {97, 53});
  PlaneScene planes(lightFrom(50, 20));
  planes.floor(0.0, 15.0);
  planes.triangle({-1, 1, 0}, {1, 1, 0}, {1, 1, 0}, {0, 1, 0}, {.double_sided = true});
  planes.triangle({0, 1, -1}, {0, 1, -1}, {0, 1, -1}, {0, 0, 0}, {.double_sided = true});
  giveScene(planes.scene(), camera);
  EXPECT_EQ(allAre(shadow(), 1.0F), "");
}

TEST_P(ShadowTest, WhatCastsIsWhatTheLightWouldSee) {
  const Camera camera = shadowCamera({0, 1.7, 3}, -0.25, {97, 53});
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
  const Camera camera = shadowCamera({0, 1.7, 3}, -0.25, {33, 17});
  PlaneScene planes(lightFrom(60, 20));
  planes.floor(0.0, 15.0).box({-2, 1, -2}, {2, 2, 2});
  planes.scene().directional_lights.clear();
  giveScene(planes.scene(), camera);
  EXPECT_EQ(allAre(shadow(), 1.0F), "");
}

TEST_P(ShadowTest, ImagesOfAnySizeAreDrawn) {
  for (const Size size : {Size{1, 1}, {3, 1}, {1, 5}, {7, 3}}) {
    PlaneScene planes(lightFrom(60, 20));
    giveScene(planes.floor(0.0, 40.0).scene(), shadowCamera({0, 1.7, 3}, -std::numbers::pi / 4.0, size));
    EXPECT_EQ(allAre(shadow(), 1.0F), "") << size.width << " x " << size.height;
  }
}

}  // namespace ssrkit
