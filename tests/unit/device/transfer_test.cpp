#include <array>
#include <random>

#include "device/format.h"
#include "device_fixture.h"

namespace ssrkit {
namespace {

constexpr std::array kAllFormats{Format::kR8ui,     Format::kRgba8,   Format::kRgba8Srgb, Format::kRg16i,
                                 Format::kRgba16ui, Format::kRgba16f, Format::kR32f,      Format::kRg32f,
                                 Format::kRgba32f,  Format::kD32f};

class TransferTest : public DeviceTest {};
SSRKIT_ON_EVERY_DEVICE(TransferTest);
class TransferDeathTest : public TransferTest {};
SSRKIT_ON_EVERY_DEVICE(TransferDeathTest);

std::vector<std::byte> randomTexels(Format format, std::size_t byte_count) {
  std::mt19937 random(7);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same texels in every run
  std::vector<std::byte> bytes(byte_count);
  if (format == Format::kD32f) {  // a depth outside 0..1 may be clamped
    std::vector<float> depths(byte_count / sizeof(float));
    for (float& depth : depths) {
      depth = static_cast<float>(random() >> 8) * 0x1p-24F;
    }
    std::memcpy(bytes.data(), depths.data(), byte_count);
    return bytes;
  }
  for (std::byte& byte : bytes) {
    byte = static_cast<std::byte>(random());
  }
  return bytes;
}

TEST_P(TransferTest, EveryFormatReadsBackEveryBitOfEveryMip) {
  for (const Format format : kAllFormats) {
    SCOPED_TRACE(formatName(format));
    const auto odd = image(format, {7, 5}, 3);
    for (int mip = 0; mip < 3; ++mip) {
      upload(*odd, mip, randomTexels(format, mipByteCount(odd->desc(), mip)));
    }
    for (int mip = 0; mip < 3; ++mip) {
      EXPECT_EQ(readBytes(*odd, mip), randomTexels(format, mipByteCount(odd->desc(), mip))) << "mip " << mip;
    }
  }
}

TEST_P(TransferTest, ACopyLandsAtItsCornerAndLeavesTheRest) {
  for (const Format format : {Format::kR32f, Format::kD32f}) {
    SCOPED_TRACE(formatName(format));
    const auto from = image(format, {4, 6}, 2);
    const auto to = image(format, {5, 4});
    upload(*from, 1, std::vector<float>{0.1F, 0.2F, 0.3F, 0.4F, 0.5F, 0.6F});
    upload(*to, 0, std::vector<float>(20, 0.75F));
    ASSERT_TRUE(device().copy(*from, 1, {2, 3}, *to, 3, 1));
    EXPECT_EQ(read<float>(*to), (std::vector<float>{0.75F, 0.75F, 0.75F, 0.75F, 0.75F,  //
                                                    0.75F, 0.75F, 0.75F, 0.1F,  0.2F,   //
                                                    0.75F, 0.75F, 0.75F, 0.3F,  0.4F,   //
                                                    0.75F, 0.75F, 0.75F, 0.5F,  0.6F}));
  }
}

TEST_P(TransferTest, ACopyTakesNoMoreThanItsSize) {
  const auto from = image(Format::kR32f, {3, 2});
  const auto to = image(Format::kR32f, {3, 2});
  upload(*from, 0, std::vector<float>{1, 2, 3, 4, 5, 6});
  upload(*to, 0, std::vector<float>(6, 9.0F));
  ASSERT_TRUE(device().copy(*from, 0, {2, 1}, *to, 1, 1));
  EXPECT_EQ(read<float>(*to), (std::vector<float>{9, 9, 9, 9, 1, 2}));
}

TEST_P(TransferTest, AnImageOfTheLongestSideWorks) {
  constexpr int kEveryDevices = 8192;  // vk-swiftshader's; the others' is 16384
  const auto wide = image(Format::kR8ui, {kEveryDevices, 1});
  std::vector<std::uint8_t> texels(kEveryDevices);
  texels.back() = 201;
  upload(*wide, 0, texels);
  EXPECT_EQ(read<std::uint8_t>(*wide), texels);
}

TEST_P(TransferTest, AnImageThatNoDeviceCanHoldIsAnError) {
  for (const Size size : {Size{0, 4}, Size{4, -1}, Size{100000, 4}}) {
    const auto refused = device().createImage({"impossible", Format::kR32f, size, 1});
    ASSERT_FALSE(refused);
    EXPECT_NE(sentence(refused.error()).find("impossible"), std::string::npos);
  }
}

TEST_P(TransferTest, AnImageOfFourGibibytesIsASetUpError) {
  const auto refused = device().createImage({"vast", Format::kRgba32f, {16384, 16384}, 1});
  ASSERT_FALSE(refused);
  // SwiftShader's longest side is shorter: it is refused for that already.
  EXPECT_EQ(refused.error().kind, GetParam() == "vk-swiftshader" ? ErrorKind::kInput : ErrorKind::kSetup);
  EXPECT_NE(sentence(refused.error()).find("16384 x 16384"), std::string::npos);
  EXPECT_NE(image(Format::kRgba32f, {4, 4}), nullptr) << "the device works on";
}

TEST_P(TransferDeathTest, AnUploadOfTheWrongSizeStopsTheProgram) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto small = image(Format::kR32f, {2, 2});
  const std::vector<float> values(3);
  EXPECT_DEATH((void)device().upload(*small, 0, std::as_bytes(std::span(values))), "12 against 16");
}

TEST_P(TransferDeathTest, ACopyPastTheEdgeStopsTheProgram) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto from = image(Format::kR32f, {2, 2});
  const auto to = image(Format::kR32f, {4, 4});
  EXPECT_DEATH((void)device().copy(*from, 0, {2, 2}, *to, 3, 0), "5 against 4");
  EXPECT_DEATH((void)device().copy(*from, 0, {3, 2}, *to, 0, 0), "3 against 2");
}

}  // namespace
}  // namespace ssrkit
