#include "image/exr.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "../temporary_folder.h"
#include "base/atomic_file.h"
#include "hand_made_exr.h"

namespace ssrkit {
namespace {

using test::TemporaryFolder;
using testing::HandMadeExr;
using testing::PixelType;

std::vector<std::uint32_t> bitsOf(const std::vector<float>& values) {
  std::vector<std::uint32_t> bits;
  bits.reserve(values.size());
  for (const float value : values) {
    bits.push_back(std::bit_cast<std::uint32_t>(value));
  }
  return bits;
}

TEST(ReadExr, GivesTheFirstRowOnTopAndTheChannelsInTheOrderAskedFor) {
  const TemporaryFolder folder;
  HandMadeExr exr{.width = 2, .height = 2, .channels = {}};
  exr.channels = {{"a", PixelType::kFloat, bitsOf({1, 2, 3, 4})},
                  {"b", PixelType::kFloat, bitsOf({10, 20, 30, 40})},
                  {"c", PixelType::kFloat, bitsOf({100, 200, 300, 400})}};
  ASSERT_TRUE(writeFileAtomically(folder / "f.exr", exr.bytes()));
  const Expected<Image> image = readExr(folder / "f.exr", {.channels = {"c", "a"}, .size = Size{2, 2}});
  ASSERT_TRUE(image) << sentence(image.error());
  EXPECT_EQ(image->channels, (std::vector<std::string>{"c", "a"}));
  EXPECT_EQ(image->data, (std::vector<float>{100, 1, 200, 2, 300, 3, 400, 4}));
}

// Halves by their bits (IEEE 754-2008 binary16): 1.5, the smallest subnormal 2^-24, 65504, minus infinity.
TEST(ReadExr, ConvertsHalvesExactly) {
  const TemporaryFolder folder;
  HandMadeExr exr{.width = 4, .height = 1, .channels = {}};
  exr.channels = {{"Y", PixelType::kHalf, {0x3E00, 0x0001, 0x7BFF, 0xFC00}}};
  ASSERT_TRUE(writeFileAtomically(folder / "f.exr", exr.bytes()));
  const Expected<Image> image = readExr(folder / "f.exr");
  ASSERT_TRUE(image) << sentence(image.error());
  EXPECT_EQ(image->data,
            (std::vector<float>{1.5F, 0x1p-24F, 65504.0F, -std::numeric_limits<float>::infinity()}));
}

TEST(ReadExr, IgnoresAnIntegerChannelThatNobodyAskedFor) {
  const TemporaryFolder folder;
  HandMadeExr exr{.width = 1, .height = 1, .channels = {}};
  exr.channels = {{"Z", PixelType::kFloat, bitsOf({7})}, {"id", PixelType::kUint, {42}}};
  ASSERT_TRUE(writeFileAtomically(folder / "f.exr", exr.bytes()));
  const Expected<Image> image = readExr(folder / "f.exr", {.channels = {"Z"}, .size = {}});
  ASSERT_TRUE(image) << sentence(image.error());
  EXPECT_EQ(image->data, std::vector<float>{7});
}

TEST(ReadExr, ReadsTiles) {
  const TemporaryFolder folder;
  const std::string path = (folder / "tiled.exr").string();
  OIIO::ImageSpec spec(5, 3, 1, OIIO::TypeDesc::FLOAT);
  spec.channelnames = {"dist_view"};
  spec.tile_width = spec.tile_height = 16;
  std::vector<float> values(15);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = static_cast<float>(i) * 0.1F;
  }
  const auto output = OIIO::ImageOutput::create("exr");
  ASSERT_TRUE(output->open(path, spec) && output->write_image(OIIO::TypeDesc::FLOAT, values.data()) &&
              output->close());
  const Expected<Image> image = readExr(path);
  ASSERT_TRUE(image) << sentence(image.error());
  EXPECT_EQ(image->data, values);
}

TEST(WriteExr, IsLosslessForEveryKindOfFloat) {
  const TemporaryFolder folder;
  Image image({3, 3}, {"texel.x", "class", "R"});
  for (std::size_t i = 0; i < image.data.size(); ++i) {
    image.data[i] = std::bit_cast<float>(0x9E3779B9U * static_cast<std::uint32_t>(i + 1));  // any bit pattern
  }
  image.at(0, 0, 0) = std::numeric_limits<float>::infinity();
  image.at(1, 0, 0) = std::bit_cast<float>(0x7FC12345U);  // a NaN with a payload
  image.at(2, 0, 0) = std::numeric_limits<float>::denorm_min();
  image.at(0, 1, 0) = -0.0F;
  image.at(1, 1, 0) = 16777216.0F;
  ASSERT_TRUE(writeExr(folder / "f.exr", image));
  const Expected<Image> read = readExr(folder / "f.exr", {.channels = image.channels, .size = image.size});
  ASSERT_TRUE(read) << sentence(read.error());
  EXPECT_EQ(bitsOf(read->data), bitsOf(image.data));
}

TEST(WriteExr, GivesTheSameBytesForTheSameImage) {
  const TemporaryFolder folder;
  Image image({40, 30}, {"R", "G", "B"});
  image.at(7, 7, 1) = 0.25F;
  ASSERT_TRUE(writeExr(folder / "a.exr", image, {{"stage", "hiz"}}));
  ASSERT_TRUE(writeExr(folder / "b.exr", image, {{"stage", "hiz"}}));
  EXPECT_EQ(readFile(folder / "a.exr").value(), readFile(folder / "b.exr").value());
}

TEST(WriteExr, PutsTheMetadataIntoTheHeader) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeExr(folder / "f.exr", Image({1, 1}, {"Y"}), {{"device", "gl-osmesa"}}));
  const auto input = OIIO::ImageInput::open((folder / "f.exr").string());
  ASSERT_TRUE(input);
  EXPECT_EQ(input->spec().get_string_attribute("ssrkit:device"), "gl-osmesa");
  EXPECT_EQ(input->spec().format, OIIO::TypeDesc(OIIO::TypeDesc::FLOAT));
}

TEST(WriteExr, LeavesNothingBehindWhereItMayNotWrite) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeFileAtomically(folder / "plain", "x"));
  const auto written = writeExr(folder / "plain/f.exr", Image({1, 1}, {"Y"}));
  ASSERT_FALSE(written);
  EXPECT_EQ(exitCode(written.error()), 3);
}

}  // namespace
}  // namespace ssrkit
