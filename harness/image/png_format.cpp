#include <fmt/format.h>
#include <png.h>

#include <memory>

#include "image/codec.h"
#include "image/picture_formats.h"

namespace ssrkit {

namespace {

struct FreePng {
  void operator()(png_image* png) const { png_image_free(png); }
};

}  // namespace

std::string encodePng(const ByteImage& image, std::vector<unsigned char>& bytes) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.size.width);
  png.height = static_cast<png_uint_32>(image.size.height);
  png.format = image.channel_count == 3 ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;
  png.flags = PNG_IMAGE_FLAG_FAST;  // previews are written by every run
  png_alloc_size_t byte_count = PNG_IMAGE_PNG_SIZE_MAX(png);
  bytes.resize(byte_count);
  constexpr int kAsIs = 0;
  constexpr int kPackedRows = 0;
  if (png_image_write_to_memory(&png, bytes.data(), &byte_count, kAsIs, image.data.data(), kPackedRows,
                                nullptr) == 0) {
    return png.message;
  }
  bytes.resize(byte_count);
  return "";
}

std::string decodePng(const std::string& file, ByteImage& image) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&png, file.data(), file.size()) == 0) {
    return fmt::format("it is not a PNG file, or it is damaged: {}", png.message);
  }
  const std::unique_ptr<png_image, FreePng> guard(&png);
  if (png.width > kMaxImageSide || png.height > kMaxImageSide) {
    return fmt::format("it is {} x {} texels, and the kit reads up to {} on a side", png.width, png.height,
                       kMaxImageSide);
  }
  png.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;
  png.format &= PNG_FORMAT_FLAG_COLOR | PNG_FORMAT_FLAG_ALPHA;  // 8 bits, no palette
  image = ByteImage(Size{static_cast<int>(png.width), static_cast<int>(png.height)},
                    static_cast<int>(PNG_IMAGE_PIXEL_CHANNELS(png.format)));
  const bool done = png_image_finish_read(&png, nullptr, image.data.data(), 0, nullptr) != 0;
  return done ? "" : fmt::format("it is damaged: {}", png.message);
}

}  // namespace ssrkit
