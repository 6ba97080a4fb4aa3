#include <png.h>

#include "image/picture_formats.h"

namespace ssrkit {

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

}  // namespace ssrkit
