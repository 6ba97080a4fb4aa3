#include "image/png.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "base/atomic_file.h"
#include "base/check.h"
#include "image/codec.h"

namespace ssrkit {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMaxFileBytes = std::size_t{1} << 28;

tl::unexpected<Error> readError(const fs::path& path, std::string problem) {
  return inputError(fmt::format("read '{}'", path.string()), std::move(problem), {}, "write it again as PNG");
}

// Whether the chunks follow each other up to IEND: libpng looks at nothing that comes after the texels.
bool isWholePng(std::string_view file) {
  constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
  constexpr std::size_t kChunkFrame = 12;  // length, type and checksum
  if (!file.starts_with(kSignature)) {
    return false;
  }
  file.remove_prefix(kSignature.size());
  while (file.size() >= kChunkFrame) {
    std::size_t length = 0;
    for (const char byte : file.substr(0, 4)) {
      length = length * 256 + static_cast<unsigned char>(byte);
    }
    if (length > file.size() - kChunkFrame) {
      return false;
    }
    if (file.substr(4, 4) == "IEND") {
      return true;
    }
    file.remove_prefix(kChunkFrame + length);
  }
  return false;
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
  const auto codec = imageCodec();
  if (!codec) {
    return tl::make_unexpected(codec.error());
  }
  std::vector<unsigned char> bytes;
  if (std::string problem = (*codec)->encodePng(image, bytes); !problem.empty()) {
    return setupError(fmt::format("encode '{}' as PNG", path.string()), std::move(problem));
  }
  return writeFileAtomically(path,
                             std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

Expected<ByteImage> readPng(const fs::path& path) {
  const Expected<std::string> file = readFile(path, kMaxFileBytes);
  if (!file) {
    return tl::make_unexpected(file.error());
  }
  if (!isWholePng(*file)) {
    return readError(path, "it is not a PNG file, or it is cut short");
  }
  const auto codec = imageCodec();
  if (!codec) {
    return tl::make_unexpected(codec.error());
  }
  ByteImage image;
  if (std::string problem = (*codec)->decodePng(*file, image); !problem.empty()) {
    return readError(path, std::move(problem));
  }
  return image.channel_count < 3 ? spreadGrey(image) : image;
}

}  // namespace ssrkit
