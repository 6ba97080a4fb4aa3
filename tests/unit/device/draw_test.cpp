#include <array>
#include <limits>

#include "device_fixture.h"

namespace ssrkit {
namespace {

class DrawTest : public DeviceTest {};
SSRKIT_ON_EVERY_DEVICE(DrawTest);

TEST_P(DrawTest, RowZeroOfFragCoordIsRowZeroInMemory) {
  const Size size{5, 3};
  const auto target = image(Format::kRgba32f, size);
  const auto coordinates = screenProgram("coordinate.frag", {Format::kRgba32f});
  draw(passTo(*target, *coordinates));
  std::vector<float> expected;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      expected.insert(expected.end(),
                      {static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F, -1.0F, 0.5F});
    }
  }
  EXPECT_EQ(read<float>(*target), expected);
}

TEST_P(DrawTest, NothingIsDrawnOutsideTheViewport) {
  const auto target = image(Format::kRg32f, {4, 4});
  const auto coordinates = screenProgram("coordinate.frag", {Format::kRg32f});
  PassDesc pass = passTo(*target, *coordinates);
  pass.colour[0].clear = std::array{9.0, 8.0, 0.0, 0.0};
  pass.viewport = {1, 2, 3, 1};
  draw(pass);
  std::vector<float> expected;
  for (int i = 0; i < 16; ++i) {
    expected.insert(expected.end(), {9.0F, 8.0F});  // the clear is of the whole image
  }
  for (std::size_t x = 1; x < 4; ++x) {
    expected[2 * (8 + x)] = static_cast<float>(x) + 0.5F;
    expected[2 * (8 + x) + 1] = 2.5F;
  }
  EXPECT_EQ(read<float>(*target), expected);
}

TEST_P(DrawTest, WhatIsNotClearedIsKept) {
  const auto target = image(Format::kR32f, {2, 2});
  upload(*target, 0, std::vector<float>{1.0F, 2.0F, 3.0F, 4.0F});
  const auto coordinates = screenProgram("coordinate.frag", {Format::kR32f});
  PassDesc pass = passTo(*target, *coordinates);
  pass.viewport = {0, 1, 1, 1};
  draw(pass);
  EXPECT_EQ(read<float>(*target), (std::vector<float>{1.0F, 2.0F, 0.5F, 4.0F}));
}

TEST_P(DrawTest, ManyTargetsOfManyKindsKeepTheirExactValues) {
  const Size size{2, 2};
  const auto floats = image(Format::kRgba32f, size);
  const auto signed_integers = image(Format::kRg16i, size);
  const auto unsigned_integers = image(Format::kRgba16ui, size);
  const auto bytes = image(Format::kR8ui, size);
  const auto many = screenProgram("many_targets.frag",
                                  {Format::kRgba32f, Format::kRg16i, Format::kRgba16ui, Format::kR8ui});
  PassDesc pass = passTo(*floats, *many);
  for (DeviceImage* const target : {signed_integers.get(), unsigned_integers.get(), bytes.get()}) {
    pass.colour.push_back({.image = target, .mip = 0, .clear = {}});
  }
  draw(pass);
  const std::vector<float> float_texels = read<float>(*floats);
  EXPECT_EQ(std::vector(float_texels.begin(), float_texels.begin() + 4),
            (std::vector<float>{0.1F, -2.0F, 3.0e30F, 4.0F}));
  EXPECT_EQ(read<std::int16_t>(*signed_integers),
            (std::vector<std::int16_t>{-32768, 32767, -32767, 32767, -32768, 32767, -32767, 32767}));
  const std::vector<std::uint16_t> shorts = read<std::uint16_t>(*unsigned_integers);
  EXPECT_EQ(std::vector(shorts.begin(), shorts.begin() + 4),
            (std::vector<std::uint16_t>{0, 1, 65534, 65535}));
  EXPECT_EQ(read<std::uint8_t>(*bytes), (std::vector<std::uint8_t>{200, 200, 201, 201}));
}

TEST_P(DrawTest, ALargerTargetIsDrawnToInItsCorner) {
  const auto floats = image(Format::kRgba32f, {2, 2});
  const auto signed_integers = image(Format::kRg16i, {2, 2});
  const auto unsigned_integers = image(Format::kRgba16ui, {2, 2});
  const auto wide = image(Format::kR8ui, {4, 5});
  upload(*wide, 0, std::vector<std::uint8_t>(20, 7));
  const auto many = screenProgram("many_targets.frag",
                                  {Format::kRgba32f, Format::kRg16i, Format::kRgba16ui, Format::kR8ui});
  PassDesc pass = passTo(*floats, *many);
  for (DeviceImage* const target : {signed_integers.get(), unsigned_integers.get(), wide.get()}) {
    pass.colour.push_back({.image = target, .mip = 0, .clear = {}});
  }
  draw(pass);
  std::vector<std::uint8_t> expected(20, 7);
  expected[0] = expected[1] = 200;
  expected[4] = expected[5] = 201;
  EXPECT_EQ(read<std::uint8_t>(*wide), expected);
  pass.colour.back().clear = std::array{9.0, 0.0, 0.0, 0.0};
  pass.draws.clear();
  draw(pass);
  const std::vector<std::uint8_t> cleared = read<std::uint8_t>(*wide);
  for (const std::size_t i : {0, 1, 4, 5}) {
    EXPECT_EQ(cleared[i], 9);
  }
}

TEST_P(DrawTest, ClearsOfEveryKindArriveExactly) {
  const Size size{3, 1};
  const auto floats = image(Format::kRgba32f, size);
  const auto signed_integers = image(Format::kRg16i, size);
  const auto unsigned_integers = image(Format::kRgba16ui, size);
  const auto bytes = image(Format::kR8ui, size);
  const auto many = screenProgram("many_targets.frag",
                                  {Format::kRgba32f, Format::kRg16i, Format::kRgba16ui, Format::kR8ui});
  PassDesc pass = passTo(*floats, *many);
  pass.viewport = {0, 0, 1, 1};  // the texels beside it keep the clear
  pass.colour[0].clear = std::array{0.1, std::numeric_limits<double>::infinity(), -3.0, 1e-30};
  pass.colour.push_back({signed_integers.get(), 0, std::array{-1.0, -30000.0, 0.0, 0.0}});
  pass.colour.push_back({unsigned_integers.get(), 0, std::array{7.0, 65535.0, 0.0, 1.0}});
  pass.colour.push_back({bytes.get(), 0, std::array{255.0, 0.0, 0.0, 0.0}});
  draw(pass);
  const std::vector<float> float_texels = read<float>(*floats);
  EXPECT_EQ(std::vector(float_texels.end() - 4, float_texels.end()),
            (std::vector<float>{0.1F, std::numeric_limits<float>::infinity(), -3.0F, 1e-30F}));
  EXPECT_EQ(read<std::int16_t>(*signed_integers),
            (std::vector<std::int16_t>{-32768, 32767, -1, -30000, -1, -30000}));
  const std::vector<std::uint16_t> shorts = read<std::uint16_t>(*unsigned_integers);
  EXPECT_EQ(std::vector(shorts.end() - 4, shorts.end()), (std::vector<std::uint16_t>{7, 65535, 0, 1}));
  EXPECT_EQ(read<std::uint8_t>(*bytes), (std::vector<std::uint8_t>{200, 255, 255}));
}

TEST_P(DrawTest, StoredColoursAreRoundedToTheirFormat) {
  const std::array<float, 4> colour{0.2F, 0.8F, 1.5F, 1.0F / 3.0F};
  const auto texel = [&](Format format) {
    const auto target = image(format, {1, 1});
    const auto constant = screenProgram("constant.frag", {format});
    PassDesc pass = passTo(*target, *constant);
    pass.uniforms = bytesOf(colour);
    draw(pass);
    return readBytes(*target, 0);
  };
  const auto bytes = [](std::initializer_list<int> values) {
    std::vector<std::byte> result;
    for (const int value : values) {
      result.push_back(static_cast<std::byte>(value));
    }
    return result;
  };
  EXPECT_EQ(texel(Format::kRgba8), bytes({51, 204, 255, 85}));
  // 255 * (1.055 c^(1/2.4) - 0.055): 123.55 and 231.11; alpha is linear.
  EXPECT_EQ(texel(Format::kRgba8Srgb), bytes({124, 231, 255, 85}));
  // The nearest halves: 0.2 = 1638.4 * 2^-13, 0.8 = 1638.4 * 2^-11, 1/3 = 1365.3 * 2^-12.
  EXPECT_EQ(texel(Format::kRgba16f), bytes({0x66, 0x32, 0x66, 0x3a, 0x00, 0x3e, 0x55, 0x35}));
}

TEST_P(DrawTest, APassDrawsToItsMipAlone) {
  const auto pyramid = image(Format::kR32f, {4, 4}, 3);
  upload(*pyramid, 0, std::vector<float>(16, 1.0F));
  upload(*pyramid, 2, std::vector<float>{3.0F});
  const auto coordinates = screenProgram("coordinate.frag", {Format::kR32f});
  draw(passTo(*pyramid, *coordinates, 1));
  EXPECT_EQ(read<float>(*pyramid, 0), std::vector<float>(16, 1.0F));
  EXPECT_EQ(read<float>(*pyramid, 1), (std::vector<float>{0.5F, 1.5F, 0.5F, 1.5F}));
  EXPECT_EQ(read<float>(*pyramid, 2), std::vector<float>{3.0F});
}

}  // namespace
}  // namespace ssrkit
