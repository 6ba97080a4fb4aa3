// The only file that is linked to OpenImageIO, built as a module (image/codec.h).
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "image/codec.h"

namespace ssrkit {

namespace {

// zlib's fastest level on 16 scan lines at a time. A 640 x 360 hit record takes 30 ms and 0.75 MiB; level 6
// takes 51 ms for 0.63 MiB, and 7 MiB uncompressed would make a run of 200 files 700 MiB.
constexpr const char* kExrCompression = "zip:1";
constexpr int kPngFastestLevel = 1;  // previews are written by every run; level 6 takes twice as long
constexpr int kPngFilterSub = 0x10;

std::string orUnknown(const std::string& problem) {
  return problem.empty() ? "OpenImageIO does not say why" : problem;
}

template <class Io>
std::string problemOf(const std::unique_ptr<Io>& io) {
  return orUnknown(io ? io->geterror() : OIIO::geterror());
}

std::string encode(const char* format, const OIIO::ImageSpec& spec, const OIIO::TypeDesc& type,
                   const void* data, std::vector<unsigned char>& bytes) {
  // Encoded in memory: OpenImageIO's own file writing hides the reason of a failure.
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(format);
  const bool done = output && output->set_ioproxy(&memory) && output->open("picture", spec) &&
                    output->write_image(type, data) && output->close();
  return done ? "" : problemOf(output);
}

std::string encodeExr(const Image& image, const std::map<std::string, std::string>& metadata,
                      std::vector<unsigned char>& bytes) {
  OIIO::ImageSpec spec(image.size.width, image.size.height, static_cast<int>(image.channelCount()),
                       OIIO::TypeDesc::FLOAT);
  spec.channelnames = image.channels;
  spec.attribute("compression", kExrCompression);
  // Else OpenImageIO writes the time of day, and the same image gives other bytes each second.
  spec.attribute("DateTime", "1970:01:01 00:00:00");
  for (const auto& [key, value] : metadata) {
    spec.attribute("ssrkit:" + key, value);
  }
  return encode("exr", spec, OIIO::TypeDesc::FLOAT, image.data.data(), bytes);
}

// Reads the smallest range that holds the wanted channels in one go (each call would decompress the whole
// file again) and puts them in the wanted order.
std::string decodeExr(const std::string& file, Image& image) {
  // OIIO 2.4 takes no const.
  OIIO::Filesystem::IOMemReader memory(const_cast<char*>(file.data()), file.size());
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create("exr", false, nullptr, &memory);
  OIIO::ImageSpec spec;
  if (!input || !input->set_ioproxy(&memory) || !input->open("picture", spec)) {
    return "it is damaged: " + problemOf(input);
  }
  std::vector<std::size_t> numbers;
  for (const std::string& channel : image.channels) {
    const auto found = std::ranges::find(spec.channelnames, channel);
    numbers.push_back(static_cast<std::size_t>(found - spec.channelnames.begin()));
  }
  const auto [first, last] = std::ranges::minmax(numbers);
  if (last >= spec.channelnames.size() || spec.width != image.size.width ||
      spec.height != image.size.height || spec.deep) {
    return "its header contradicts itself";
  }
  const std::size_t range = last - first + 1;
  std::vector<float> texels(image.texelCount() * range);
  if (!input->read_image(0, 0, static_cast<int>(first), static_cast<int>(last) + 1, OIIO::TypeDesc::FLOAT,
                         texels.data())) {
    return "it is damaged: " + problemOf(input);
  }
  for (std::size_t texel = 0; texel < image.texelCount(); ++texel) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      image.data[texel * numbers.size() + i] = texels[texel * range + numbers[i] - first];
    }
  }
  return "";
}

std::string encodePng(const ByteImage& image, std::vector<unsigned char>& bytes) {
  OIIO::ImageSpec spec(image.size.width, image.size.height, image.channel_count, OIIO::TypeDesc::UINT8);
  spec.attribute("png:compressionLevel", kPngFastestLevel);
  spec.attribute("png:filter", kPngFilterSub);
  spec.attribute("oiio:ColorSpace", "sRGB");
  spec.attribute("oiio:UnassociatedAlpha", 1);
  return encode("png", spec, OIIO::TypeDesc::UINT8, image.data.data(), bytes);
}

std::string decodePng(const std::string& file, ByteImage& image) {
  OIIO::Filesystem::IOMemReader memory(const_cast<char*>(file.data()), file.size());
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create("png", false, nullptr, &memory);
  OIIO::ImageSpec spec;
  if (!input || !input->set_ioproxy(&memory) || !input->open("picture", spec, config)) {
    return "it is not a PNG file, or it is damaged";
  }
  if (spec.width > kMaxImageSide || spec.height > kMaxImageSide) {
    return fmt::format("it is {} x {} texels, and the kit reads up to {} on a side", spec.width, spec.height,
                       kMaxImageSide);
  }
  image = ByteImage(Size{spec.width, spec.height}, spec.nchannels);
  const bool done = input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, image.data.data());
  return done ? "" : "it is damaged: " + problemOf(input);
}

// OpenImageIO tells a text's inked box but not a character's advance: the box of "X|" ends that much further
// right than the box of "|".
int advanceOf(const std::string& character, int height_px, const std::string& font_file) {
  const OIIO::ROI bar = OIIO::ImageBufAlgo::text_size("|", height_px, font_file);
  const OIIO::ROI both = OIIO::ImageBufAlgo::text_size(character + "|", height_px, font_file);
  return bar.defined() && both.defined() ? both.xend - bar.xend : 0;
}

Glyph renderGlyph(const std::string& character, int height_px, const std::string& font_file) {
  Glyph glyph;
  glyph.advance_px = advanceOf(character, height_px, font_file);
  const OIIO::ROI box = OIIO::ImageBufAlgo::text_size(character, height_px, font_file);
  if (!box.defined() || box.width() < 1 || box.height() < 1) {
    return glyph;
  }
  constexpr int kMargin = 1;  // the box is of whole pixels and smoothing may reach past it
  glyph.left_px = box.xbegin - kMargin;
  glyph.top_px = box.ybegin - kMargin;
  glyph.size = Size{box.width() + 2 * kMargin, box.height() + 2 * kMargin};
  OIIO::ImageBuf mask(OIIO::ImageSpec(glyph.size.width, glyph.size.height, 1, OIIO::TypeDesc::UINT8),
                      OIIO::InitializePixels::Yes);
  if (!OIIO::ImageBufAlgo::render_text(mask, -glyph.left_px, -glyph.top_px, character, height_px,
                                       font_file)) {
    return Glyph{};
  }
  glyph.coverage.resize(static_cast<std::size_t>(glyph.size.width) *
                        static_cast<std::size_t>(glyph.size.height));
  mask.get_pixels(mask.roi(), OIIO::TypeDesc::UINT8, glyph.coverage.data());
  return glyph;
}

// The library's limits, and no threads of its own: workers and oracles share the cores, and callers that
// write many files write them side by side.
void setLimits() {
  constexpr int kMebibyte = 1 << 20;
  OIIO::attribute("threads", 1);
  OIIO::attribute("exr_threads", -1);  // -1: no thread pool of OpenEXR's own
  OIIO::attribute("limits:channels", kMaxImageChannels);
  OIIO::attribute("limits:imagesize_MB", static_cast<int>(kMaxImageBytes / kMebibyte));
}

}  // namespace

}  // namespace ssrkit

extern "C" const ssrkit::ImageCodec* ssrkitImageCodec() {
  static const ssrkit::ImageCodec codec = [] {
    ssrkit::setLimits();
    return ssrkit::ImageCodec{.encodeExr = ssrkit::encodeExr,
                              .decodeExr = ssrkit::decodeExr,
                              .encodePng = ssrkit::encodePng,
                              .decodePng = ssrkit::decodePng,
                              .renderGlyph = ssrkit::renderGlyph};
  }();
  return &codec;
}
