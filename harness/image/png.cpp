#include "image/png.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "base/atomic_file.h"
#include "base/check.h"
#include "image/oiio_setup.h"

namespace ssrkit {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMaxFileBytes = std::size_t{1} << 28;
constexpr int kFastestLevel = 1;  // previews are written by every run; level 6 takes twice as long
constexpr int kPngFilterSub = 0x10;

tl::unexpected<Error> readError(const fs::path& path, std::string problem) {
  return inputError(fmt::format("read '{}'", path.string()), std::move(problem), {}, "write it again as PNG");
}

// Grey (1) and grey with alpha (2) channels become RGB and RGBA.
ByteImage spreadGrey(const ByteImage& grey) {
  ByteImage colour(grey.size, grey.channel_count + 2);
  const auto from_stride = static_cast<std::size_t>(grey.channel_count);
  const auto to_stride = static_cast<std::size_t>(colour.channel_count);
  for (std::size_t i = 0; i < grey.texelCount(); ++i) {
    const std::uint8_t* const from = grey.data.data() + i * from_stride;
    std::uint8_t* const to = colour.data.data() + i * to_stride;
    std::fill_n(to, 3, from[0]);
    if (from_stride == 2) {
      to[3] = from[1];
    }
  }
  return colour;
}

}  // namespace

Expected<void> writePng(const fs::path& path, const ByteImage& image) {
  SSRKIT_CHECK(image.channel_count == 3 || image.channel_count == 4);
  SSRKIT_CHECK_EQ(image.data.size(), image.texelCount() * static_cast<std::size_t>(image.channel_count));
  setUpOiio();
  OIIO::ImageSpec spec(image.size.width, image.size.height, image.channel_count, OIIO::TypeDesc::UINT8);
  spec.attribute("png:compressionLevel", kFastestLevel);
  spec.attribute("png:filter", kPngFilterSub);
  spec.attribute("oiio:ColorSpace", "sRGB");
  spec.attribute("oiio:UnassociatedAlpha", 1);
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("png");
  if (!output || !output->set_ioproxy(&memory) || !output->open(path.string(), spec) ||
      !output->write_image(OIIO::TypeDesc::UINT8, image.data.data()) || !output->close()) {
    return setupError(fmt::format("encode '{}' as PNG", path.string()),
                      output ? output->geterror() : OIIO::geterror(), {},
                      "check the installation of the package libopenimageio2.4");
  }
  return writeFileAtomically(path,
                             std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

Expected<ByteImage> readPng(const fs::path& path) {
  setUpOiio();
  const Expected<std::string> file = readFile(path, kMaxFileBytes);
  if (!file) {
    return tl::make_unexpected(file.error());
  }
  OIIO::Filesystem::IOMemReader memory(const_cast<char*>(file->data()),
                                       file->size());  // OIIO 2.4 takes no const
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create("png", false, nullptr, &memory);
  OIIO::ImageSpec spec;
  if (!input || !input->set_ioproxy(&memory) || !input->open(path.string(), spec, config)) {
    return readError(path, "it is not a PNG file, or it is damaged");
  }
  if (spec.width > kMaxImageSide || spec.height > kMaxImageSide) {
    return readError(path, fmt::format("it is {} x {} texels, and the kit reads up to {} on a side",
                                       spec.width, spec.height, kMaxImageSide));
  }
  ByteImage image(Size{spec.width, spec.height}, spec.nchannels);
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, image.data.data())) {
    return readError(path, "it is damaged: " + input->geterror());
  }
  return image.channel_count < 3 ? spreadGrey(image) : image;
}

}  // namespace ssrkit
