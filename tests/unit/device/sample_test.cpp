#include <array>
#include <cmath>
#include <vector>

#include "device_fixture.h"

namespace ssrkit {
namespace {

// The block of look_up.frag.
struct Place {
  std::array<float, 2> uv_per_px{};
  std::array<float, 2> uv_offset{};
  float level = 0.0F;
  std::array<float, 3> padding{};
};

class SampleTest : public DeviceTest {
 protected:
  // What look_up.frag finds along the row of `count` texels: R, G, B and the width that it sees, a texel.
  std::vector<float> lookUp(const SampledImage& sampled, const Place& place, int count) {
    const auto target = image(Format::kRgba32f, {count, 1});
    const auto program = screenProgram("look_up.frag", {Format::kRgba32f});
    PassDesc pass = passTo(*target, *program);
    pass.sampled = {sampled};
    pass.uniform_binding = 1;
    pass.uniforms = bytesOf(place);
    draw(pass);
    return read<float>(*target);
  }

  std::vector<float> redsOf(const SampledImage& sampled, const Place& place, int count) {
    const std::vector<float> texels = lookUp(sampled, place, count);
    std::vector<float> reds;
    for (std::size_t i = 0; i < texels.size(); i += 4) {
      reds.push_back(texels[i]);
    }
    return reds;
  }
};
SSRKIT_ON_EVERY_DEVICE(SampleTest);

TEST_P(SampleTest, TheShaderSeesOnlyTheMipsThatItWasGiven) {
  const auto pyramid = image(Format::kR32f, {8, 8}, 4);
  for (int mip = 0; mip < 4; ++mip) {
    const auto side = static_cast<std::size_t>(8 >> mip);
    upload(*pyramid, mip, std::vector<float>(side * side, static_cast<float>(10 + mip)));
  }
  const auto seen = [&](int base_mip, int mip_count, float level) {
    const std::vector<float> texel =
        lookUp({.binding = 0, .image = pyramid.get(), .base_mip = base_mip, .mip_count = mip_count},
               {.uv_per_px = {}, .uv_offset = {0.5F, 0.5F}, .level = level}, 1);
    return std::pair(texel[0], texel[3]);
  };
  EXPECT_EQ(seen(0, 4, 0.0F), std::pair(10.0F, 8.0F));
  EXPECT_EQ(seen(0, 4, 3.0F), std::pair(13.0F, 8.0F));
  EXPECT_EQ(seen(1, 1, 0.0F), std::pair(11.0F, 4.0F));
  EXPECT_EQ(seen(1, 2, 1.0F), std::pair(12.0F, 4.0F));
  EXPECT_EQ(seen(1, 2, 5.0F), std::pair(12.0F, 4.0F)) << "past the last mip it stays there";
}

TEST_P(SampleTest, APyramidIsReducedMipByMip) {
  const auto pyramid = image(Format::kR32f, {4, 4}, 3);
  upload(*pyramid, 0, std::vector<float>{9, 8, 7, 6, 5, 4, 3, 9, 1, 2, 9, 9, 9, 9, 8, 9});
  const auto reduce = screenProgram("reduce.frag", {Format::kR32f});
  for (int mip = 1; mip < 3; ++mip) {
    PassDesc pass = passTo(*pyramid, *reduce, mip);
    pass.sampled = {{.binding = 0, .image = pyramid.get(), .base_mip = mip - 1, .mip_count = 1}};
    draw(pass);
  }
  EXPECT_EQ(read<float>(*pyramid, 1), (std::vector<float>{4, 3, 1, 8}));
  EXPECT_EQ(read<float>(*pyramid, 2), std::vector<float>{1});
}

TEST_P(SampleTest, EachAddressModeContinuesTheImageItsOwnWay) {
  const auto row = image(Format::kR32f, {4, 1});
  upload(*row, 0, std::vector<float>{1, 2, 3, 4});
  const Place from_minus_four{.uv_per_px = {0.25F, 0.0F},
                              .uv_offset = {-1.0F, 0.5F}};  // 12 texels, 4 to each side
  const auto along = [&](AddressMode mode) {
    return redsOf({.binding = 0, .image = row.get(), .address_u = mode}, from_minus_four, 12);
  };
  EXPECT_EQ(along(AddressMode::kClamp), (std::vector<float>{1, 1, 1, 1, 1, 2, 3, 4, 4, 4, 4, 4}));
  EXPECT_EQ(along(AddressMode::kRepeat), (std::vector<float>{1, 2, 3, 4, 1, 2, 3, 4, 1, 2, 3, 4}));
  EXPECT_EQ(along(AddressMode::kMirror), (std::vector<float>{4, 3, 2, 1, 1, 2, 3, 4, 4, 3, 2, 1}));
}

TEST_P(SampleTest, TheTwoAxesHaveAddressModesOfTheirOwn) {
  const auto column = image(Format::kR32f, {1, 2});
  upload(*column, 0, std::vector<float>{1, 2});
  const Place below{.uv_per_px = {}, .uv_offset = {0.5F, 1.25F}};
  EXPECT_EQ(redsOf({.binding = 0, .image = column.get(), .address_v = AddressMode::kRepeat}, below, 1),
            std::vector<float>{1});
  EXPECT_EQ(redsOf({.binding = 0, .image = column.get(), .address_u = AddressMode::kRepeat}, below, 1),
            std::vector<float>{2});
}

TEST_P(SampleTest, LinearFilteringWeighsTexelsAndMips) {
  const auto pyramid = image(Format::kR32f, {2, 1}, 2);
  upload(*pyramid, 0, std::vector<float>{0, 8});
  upload(*pyramid, 1, std::vector<float>{32});
  const SampledImage linear{
      .binding = 0, .image = pyramid.get(), .base_mip = 0, .mip_count = 2, .filter = Filter::kLinear};
  const auto at = [&](float u, float level) {
    return redsOf(linear, {.uv_per_px = {}, .uv_offset = {u, 0.5F}, .level = level}, 1)[0];
  };
  // Weights have 8 fraction bits on every device here, so eighths of a texel come out exactly.
  EXPECT_EQ(at(0.5F, 0.0F), 4.0F);
  EXPECT_EQ(at(0.375F, 0.0F), 2.0F);
  EXPECT_EQ(at(0.25F, 0.0F), 0.0F);
  EXPECT_EQ(at(0.5F, 1.0F), 32.0F);
  EXPECT_EQ(at(0.5F, 0.5F), 18.0F);  // half of 4, half of 32
}

TEST_P(SampleTest, AnSrgbImageIsReadAsLinearLight) {
  const auto grey = image(Format::kRgba8Srgb, {1, 1});
  upload(*grey, 0, std::vector<std::uint8_t>{188, 0, 255, 77});
  const std::vector<float> texel =
      lookUp({.binding = 0, .image = grey.get()}, {.uv_per_px = {}, .uv_offset = {0.5F, 0.5F}}, 1);
  // ((188/255 + 0.055) / 1.055)^2.4. Mesa's software drivers decode with a polynomial that is 7.3e-4 low
  // here.
  EXPECT_NEAR(texel[0], 0.50288646, 1e-3);
  EXPECT_EQ(texel[1], 0.0F);
  EXPECT_NEAR(texel[2], 1.0, 1e-6);
}

TEST_P(SampleTest, ADepthImageIsReadAsItWasStored) {
  const auto depth = image(Format::kD32f, {2, 1});
  upload(*depth, 0, std::vector<float>{0.1F, 0.999999F});
  EXPECT_EQ(
      redsOf({.binding = 0, .image = depth.get()}, {.uv_per_px = {0.5F, 0.0F}, .uv_offset = {0.0F, 0.5F}}, 2),
      (std::vector<float>{0.1F, 0.999999F}));
}

TEST_P(SampleTest, IntegerImagesAreReadAsIntegers) {
  const auto signed_image = image(Format::kRg16i, {2, 1});
  const auto unsigned_image = image(Format::kRgba16ui, {2, 1});
  upload(*signed_image, 0, std::vector<std::int16_t>{-1, 32767, -32768, 5});
  upload(*unsigned_image, 0, std::vector<std::uint16_t>{65535, 1, 2, 3, 4, 5, 6, 40000});
  const auto target = image(Format::kRgba32f, {2, 1});
  const auto program = screenProgram("look_up_integers.frag", {Format::kRgba32f});
  PassDesc pass = passTo(*target, *program);
  pass.sampled = {{.binding = 0, .image = signed_image.get()}, {.binding = 1, .image = unsigned_image.get()}};
  draw(pass);
  EXPECT_EQ(read<float>(*target), (std::vector<float>{-1, 32767, 65535, 3, -32768, 5, 4, 40000}));
}

TEST_P(SampleTest, APassWithoutTheImageThatItsShaderReadsIsAnError) {
  const auto target = image(Format::kRgba32f, {1, 1});
  const auto program = screenProgram("look_up.frag", {Format::kRgba32f});
  PassDesc pass = passTo(*target, *program);
  const auto refused = device().draw(pass);
  ASSERT_FALSE(refused);
  EXPECT_NE(sentence(refused.error()).find("sampler at binding 0"), std::string::npos);
}

class SampleDeathTest : public SampleTest {};
SSRKIT_ON_EVERY_DEVICE(SampleDeathTest);

TEST_P(SampleDeathTest, SamplingTheMipThatIsDrawnToStopsTheProgram) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto pyramid = image(Format::kR32f, {4, 4}, 2);
  const auto reduce = screenProgram("reduce.frag", {Format::kR32f});
  PassDesc pass = passTo(*pyramid, *reduce, 1);
  pass.sampled = {{.binding = 0, .image = pyramid.get(), .base_mip = 0, .mip_count = 2}};
  EXPECT_DEATH((void)device().draw(pass), "isDrawnTo");
}

}  // namespace
}  // namespace ssrkit
