#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <memory>

#include "base/atomic_file.h"
#include "base/check.h"
#include "image/exr.h"
#include "image/oiio_setup.h"

namespace ssrkit {

namespace fs = std::filesystem;

namespace {

// zlib's fastest level on 16 scan lines at a time. A 640 x 360 hit record takes 30 ms and 0.75 MiB; level 6
// takes 51 ms for 0.63 MiB, and 7 MiB uncompressed would make a run of 200 files 700 MiB.
constexpr const char* kCompression = "zip:1";

OIIO::ImageSpec specOf(const Image& image, const ExrMetadata& metadata) {
  OIIO::ImageSpec spec(image.size.width, image.size.height, static_cast<int>(image.channelCount()),
                       OIIO::TypeDesc::FLOAT);
  spec.channelnames = image.channels;
  spec.attribute("compression", kCompression);
  for (const auto& [key, value] : metadata) {
    spec.attribute("ssrkit:" + key, value);
  }
  return spec;
}

}  // namespace

Expected<void> writeExr(const fs::path& path, const Image& image, const ExrMetadata& metadata) {
  SSRKIT_CHECK_EQ(image.data.size(), image.texelCount() * image.channelCount());
  SSRKIT_CHECK_LT(std::size_t{0}, image.data.size());
  setUpOiio();
  // Encoded in memory: OpenImageIO's own file writing hides the reason of a failure.
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("exr");
  if (!output || !output->set_ioproxy(&memory) || !output->open(path.string(), specOf(image, metadata)) ||
      !output->write_image(OIIO::TypeDesc::FLOAT, image.data.data()) || !output->close()) {
    return setupError(fmt::format("encode '{}' as EXR", path.string()),
                      output ? output->geterror() : OIIO::geterror(), {},
                      "check the installation of the package libopenimageio2.4");
  }
  return writeFileAtomically(path,
                             std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

}  // namespace ssrkit
