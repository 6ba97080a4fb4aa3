// The alpha test against values worked out by hand.
#include "oracle/alpha_cutout.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ssrkit {
namespace {

// Two by two texels of alpha 0, 51, 102 and 255.
Texture fourTexels(Wrap wrap) {
  Texture texture;
  texture.size = {2, 2};
  texture.wrap_u = wrap;
  texture.wrap_v = wrap;
  texture.rgba = {9, 9, 9, 0, 9, 9, 9, 51, 9, 9, 9, 102, 9, 9, 9, 255};
  return texture;
}

TEST(SampleAlpha, GivesATexelAtItsCentre) {
  const Texture texture = fourTexels(Wrap::kRepeat);
  EXPECT_FLOAT_EQ(sampleAlpha(texture, {0.25F, 0.25F}), 0.0F);
  EXPECT_FLOAT_EQ(sampleAlpha(texture, {0.75F, 0.25F}), 0.2F);
  EXPECT_FLOAT_EQ(sampleAlpha(texture, {0.25F, 0.75F}), 0.4F);
  EXPECT_FLOAT_EQ(sampleAlpha(texture, {0.75F, 0.75F}), 1.0F);
}

TEST(SampleAlpha, MixesTheFourAroundAPoint) {
  EXPECT_FLOAT_EQ(sampleAlpha(fourTexels(Wrap::kClamp), {0.5F, 0.5F}), 0.4F);
  EXPECT_FLOAT_EQ(sampleAlpha(fourTexels(Wrap::kClamp), {0.5F, 0.25F}), 0.1F);
}

TEST(SampleAlpha, WrapsBeyondTheEdges) {
  // On the left edge: half the texel itself, half its neighbour beyond the edge.
  EXPECT_FLOAT_EQ(sampleAlpha(fourTexels(Wrap::kClamp), {0.0F, 0.25F}), 0.0F);
  EXPECT_FLOAT_EQ(sampleAlpha(fourTexels(Wrap::kMirror), {0.0F, 0.25F}), 0.0F);
  EXPECT_FLOAT_EQ(sampleAlpha(fourTexels(Wrap::kRepeat), {0.0F, 0.25F}), 0.1F);
  EXPECT_FLOAT_EQ(sampleAlpha(fourTexels(Wrap::kRepeat), {-3.25F, 0.75F}), 1.0F);
  EXPECT_FLOAT_EQ(sampleAlpha(fourTexels(Wrap::kMirror), {1.25F, 0.75F}), 1.0F);
  EXPECT_FLOAT_EQ(sampleAlpha(fourTexels(Wrap::kMirror), {-0.75F, 0.75F}), 1.0F);
  EXPECT_FLOAT_EQ(sampleAlpha(fourTexels(Wrap::kClamp), {7.0F, 9.0F}), 1.0F);
}

TEST(SampleAlpha, TakesCoordinatesThatAreNoPlaceAsDrawn) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(sampleAlpha(fourTexels(Wrap::kRepeat), {nan, 0.5F}), 1.0F);
  EXPECT_EQ(sampleAlpha(fourTexels(Wrap::kMirror), {0.5F, 1e30F}), 1.0F);
}

TEST(IsDrawnAt, HoldsColourTimesTextureAgainstTheCutoff) {
  Scene scene;
  scene.textures = {fourTexels(Wrap::kClamp)};
  Material material;
  material.base_colour.a = 0.5F;
  material.base_colour_texture = 0;
  EXPECT_TRUE(isDrawnAt(scene, material, {0.25F, 0.25F}));  // opaque
  material.alpha_mode = AlphaMode::kMask;
  material.alpha_cutoff = 0.2F;
  EXPECT_FALSE(isDrawnAt(scene, material, {0.75F, 0.25F}));  // 0.1
  EXPECT_TRUE(isDrawnAt(scene, material, {0.25F, 0.75F}));   // 0.2, not less
  material.alpha_mode = AlphaMode::kBlend;                   // as a mask at 0.5
  EXPECT_FALSE(isDrawnAt(scene, material, {0.25F, 0.75F}));
  EXPECT_TRUE(isDrawnAt(scene, material, {0.75F, 0.75F}));
}

}  // namespace
}  // namespace ssrkit
