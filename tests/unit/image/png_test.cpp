#include "image/png.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "../temporary_folder.h"
#include "base/atomic_file.h"

namespace ssrkit {
namespace {

using testing::TemporaryFolder;

// Made with Python's zlib and struct from the PNG specification: 2 x 2 RGB, and 2 x 1 grey with alpha.
constexpr std::array<unsigned char, 82> kRgb = {
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00,
    0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x02, 0x08, 0x02, 0x00, 0x00, 0x00, 0xfd, 0xd4, 0x9a, 0x73, 0x00,
    0x00, 0x00, 0x19, 0x49, 0x44, 0x41, 0x54, 0x78, 0x01, 0x01, 0x0e, 0x00, 0xf1, 0xff, 0x00, 0xff, 0x00,
    0x00, 0x00, 0x80, 0x00, 0x00, 0x01, 0x02, 0x03, 0xfa, 0xfb, 0xfc, 0x17, 0x7d, 0x04, 0x77, 0x63, 0x54,
    0xc0, 0x4a, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
constexpr std::array<unsigned char, 73> kGreyAlpha = {
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44,
    0x52, 0x00, 0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x01, 0x08, 0x04, 0x00, 0x00, 0x00, 0x5e,
    0x2b, 0xb7, 0x01, 0x00, 0x00, 0x00, 0x10, 0x49, 0x44, 0x41, 0x54, 0x78, 0x01, 0x01, 0x05,
    0x00, 0xfa, 0xff, 0x00, 0x4d, 0x80, 0xc8, 0x00, 0x04, 0x49, 0x01, 0x96, 0x22, 0xdf, 0xe0,
    0x7a, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};

template <std::size_t N>
std::string_view bytesOf(const std::array<unsigned char, N>& file) {
  return {reinterpret_cast<const char*>(file.data()), file.size()};
}

TEST(ReadPng, GivesTheFirstRowOnTop) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeFileAtomically(folder / "f.png", bytesOf(kRgb)));
  const Expected<ByteImage> image = readPng(folder / "f.png");
  ASSERT_TRUE(image) << sentence(image.error());
  EXPECT_EQ(image->size, (Size{2, 2}));
  EXPECT_EQ(image->data, (std::vector<std::uint8_t>{255, 0, 0, 0, 128, 0, 1, 2, 3, 250, 251, 252}));
}

TEST(ReadPng, SpreadsGreyAndDoesNotMultiplyByAlpha) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeFileAtomically(folder / "f.png", bytesOf(kGreyAlpha)));
  const Expected<ByteImage> image = readPng(folder / "f.png");
  ASSERT_TRUE(image) << sentence(image.error());
  EXPECT_EQ(image->channel_count, 4);
  EXPECT_EQ(image->data, (std::vector<std::uint8_t>{77, 77, 77, 128, 200, 200, 200, 0}));
}

TEST(ReadPng, RefusesDamageAndOtherFormats) {
  const TemporaryFolder folder;
  const std::string whole(bytesOf(kRgb));
  for (const std::string& bytes :
       {std::string(), std::string("GIF89a"), whole.substr(0, 30), whole.substr(0, 50)}) {
    ASSERT_TRUE(writeFileAtomically(folder / "f.png", bytes));
    const Expected<ByteImage> image = readPng(folder / "f.png");
    ASSERT_FALSE(image) << bytes.size() << " bytes";
    EXPECT_EQ(exitCode(image.error()), 2);
  }
}

TEST(WritePng, KeepsEveryByteOfRgbAndRgba) {
  const TemporaryFolder folder;
  for (const int channels : {3, 4}) {
    ByteImage image({17, 9}, channels);
    for (std::size_t i = 0; i < image.data.size(); ++i) {
      image.data[i] = static_cast<std::uint8_t>(i * 37);
    }
    ASSERT_TRUE(writePng(folder / "f.png", image));
    const Expected<ByteImage> read = readPng(folder / "f.png");
    ASSERT_TRUE(read) << sentence(read.error());
    EXPECT_EQ(read->channel_count, channels);
    EXPECT_EQ(read->data, image.data);
  }
}

}  // namespace
}  // namespace ssrkit
