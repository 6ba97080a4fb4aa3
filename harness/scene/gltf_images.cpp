#include "scene/gltf_images.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <limits>
#include <optional>
#include <span>
#include <string_view>

#include "base/size.h"
#include "scene/clean_name.h"
#include "scene/gltf_accessor.h"
#include "scene/gltf_uri.h"

namespace ssrkit {

namespace {

constexpr std::size_t kMaxDecodedBytes = std::size_t{256} << 20;
constexpr std::size_t kMaxMetadataBytes = std::size_t{1} << 20;

using Bytes = std::span<const std::uint8_t>;

std::size_t bigEndian(Bytes bytes, std::size_t offset, std::size_t count) {
  std::size_t value = 0;
  for (std::size_t i = 0; i < count; ++i) {
    value = value << 8U | bytes[offset + i];
  }
  return value;
}

bool startsWith(Bytes bytes, std::string_view signature) {
  return bytes.size() >= signature.size() &&
         std::equal(signature.begin(), signature.end(), bytes.begin(),
                    [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; });
}

struct HeaderSize {
  std::size_t width = 0;
  std::size_t height = 0;
};

// PNG: the IHDR chunk is the first.
std::optional<HeaderSize> pngSize(Bytes bytes) {
  if (bytes.size() < 24 || !startsWith(bytes.subspan(12), "IHDR")) {
    return std::nullopt;
  }
  return HeaderSize{bigEndian(bytes, 16, 4), bigEndian(bytes, 20, 4)};
}

// JPEG: segments from marker to marker up to the frame header (ITU-T T.81, B.2.2).
std::optional<HeaderSize> jpegSize(Bytes bytes) {
  std::size_t offset = 2;
  while (offset + 9 <= bytes.size()) {
    if (bytes[offset] != 0xFF) {
      return std::nullopt;
    }
    const std::uint8_t marker = bytes[offset + 1];
    if (marker == 0xFF) {
      ++offset;  // a fill byte
      continue;
    }
    const bool is_frame =
        marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
    if (is_frame) {
      return HeaderSize{bigEndian(bytes, offset + 7, 2), bigEndian(bytes, offset + 5, 2)};
    }
    offset += 2 + bigEndian(bytes, offset + 2, 2);
  }
  return std::nullopt;
}

// Empty when the image may be decoded. A file much larger than its own pixels could inflate without end.
std::string complaint(Bytes bytes) {
  const bool is_png = startsWith(bytes, "\x89PNG\r\n\x1A\n");
  if (!is_png && !startsWith(bytes, "\xFF\xD8")) {
    return "it is neither PNG nor JPEG";
  }
  const std::optional<HeaderSize> size = is_png ? pngSize(bytes) : jpegSize(bytes);
  if (!size || size->width == 0 || size->height == 0) {
    return "its header is broken";
  }
  const std::size_t decoded_bytes =
      size->width > kMaxImageSide || size->height > kMaxImageSide ? 0 : size->width * size->height * 4;
  if (decoded_bytes == 0 || decoded_bytes > kMaxDecodedBytes) {
    return fmt::format("it is {}x{} and the limits are {} a side and 256 MiB decoded", size->width,
                       size->height, kMaxImageSide);
  }
  if (bytes.size() > kMaxMetadataBytes + 4 * decoded_bytes) {
    return fmt::format("it is {}x{} and takes {} bytes", size->width, size->height, bytes.size());
  }
  return "";
}

// stb decodes 16-bit files to 16-bit words in the machine's byte order.
std::vector<std::uint8_t> asBytes(tinygltf::Image& image) {
  if (image.bits != 16) {
    return std::move(image.image);
  }
  std::vector<std::uint8_t> bytes(image.image.size() / 2);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const unsigned value = image.image[2 * i] | static_cast<unsigned>(image.image[2 * i + 1]) << 8U;
    bytes[i] = static_cast<std::uint8_t>((value * 255U + 32767U) / 65535U);
  }
  return bytes;
}

Expected<Texture> decode(const GltfDocument& document, int index, Bytes bytes, const std::string& place) {
  if (const std::string problem = complaint(bytes); !problem.empty()) {
    return document.source.refuse(place, problem);
  }
  tinygltf::Image image;
  std::string error;
  std::string warning;
  if (!tinygltf::LoadImageData(&image, index, &error, &warning, 0, 0, bytes.data(),
                               static_cast<int>(bytes.size()), nullptr)) {
    return document.source.refuse(place, "the image cannot be decoded", "save it again as PNG or JPEG");
  }
  Texture texture;
  texture.size = {image.width, image.height};
  texture.rgba = asBytes(image);
  const std::size_t expected =
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4;
  if (texture.rgba.size() != expected) {
    return document.source.refuse(place, "the image cannot be decoded", "save it again as PNG or JPEG");
  }
  return texture;
}

}  // namespace

Expected<Texture> decodeGltfImage(const GltfDocument& document, int index) {
  const GltfImageSource& image = document.images[static_cast<std::size_t>(index)];
  const std::string place = fmt::format("images[{}]", index);
  if (image.uri.empty()) {
    const auto bytes = bytesOfView(document, image.buffer_view, place);
    return bytes ? decode(document, index, *bytes, place) : tl::make_unexpected(bytes.error());
  }
  const auto bytes = readGltfUri(document.source, image.uri, place + ".uri");
  return bytes ? decode(document, index, *bytes, place) : tl::make_unexpected(bytes.error());
}

}  // namespace ssrkit
