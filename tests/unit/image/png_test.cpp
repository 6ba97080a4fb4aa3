#include "image/png.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "../temporary_folder.h"

namespace ssrkit {
namespace {

using test::TemporaryFolder;

TEST(WritePng, KeepsEveryByteOfRgbAndRgba) {
  const TemporaryFolder folder;
  for (const int channels : {3, 4}) {
    ByteImage image({17, 9}, channels);
    for (std::size_t i = 0; i < image.data.size(); ++i) {
      image.data[i] = static_cast<std::uint8_t>(i * 37);
    }
    ASSERT_TRUE(writePng(folder / "f.png", image));
    OIIO::ImageSpec as_stored;
    as_stored["oiio:UnassociatedAlpha"] = 1;  // not multiplied by alpha
    const auto read = OIIO::ImageInput::open((folder / "f.png").string(), &as_stored);
    ASSERT_NE(read, nullptr) << OIIO::geterror();
    EXPECT_EQ(read->spec().width, 17);
    EXPECT_EQ(read->spec().height, 9);
    ASSERT_EQ(read->spec().nchannels, channels);
    std::vector<std::uint8_t> bytes(image.data.size());
    ASSERT_TRUE(read->read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT8, bytes.data()));
    EXPECT_EQ(bytes, image.data);
  }
}

}  // namespace
}  // namespace ssrkit
