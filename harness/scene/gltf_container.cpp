#include "scene/gltf_container.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <string_view>
#include <utility>

#include "base/atomic_file.h"

namespace ssrkit {

namespace {

static_assert(std::endian::native == std::endian::little, "glTF's binary parts are little-endian");

constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;

std::uint32_t wordAt(std::string_view bytes, std::size_t offset) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + offset, sizeof(word));
  return word;
}

Expected<void> checkGlbHeader(const GltfSource& source, std::string_view bytes) {
  if (bytes.size() < kHeaderBytes + kChunkHeaderBytes) {
    return source.refuse("",
                         fmt::format("the file ends after {} bytes, inside the GLB header", bytes.size()));
  }
  if (const std::uint32_t version = wordAt(bytes, 4); version != 2) {
    return source.refuse("", fmt::format("it is GLB version {}", version),
                         "ssrkit reads glTF 2.0; convert the file with its exporter");
  }
  if (const std::size_t declared = wordAt(bytes, 8); declared > bytes.size()) {
    return source.refuse("",
                         fmt::format("the file has {} bytes and its header says {}", bytes.size(), declared),
                         "it was cut short; copy it again");
  }
  return {};
}

Expected<GltfContainer> takeApartGlb(const GltfSource& source, std::string_view bytes) {
  if (auto header = checkGlbHeader(source, bytes); !header) {
    return tl::make_unexpected(header.error());
  }
  bytes = bytes.substr(0, wordAt(bytes, 8));
  GltfContainer container;
  std::size_t offset = kHeaderBytes;
  for (int chunk = 0; bytes.size() >= offset + kChunkHeaderBytes; ++chunk) {
    const std::size_t size = wordAt(bytes, offset);
    const std::uint32_t type = wordAt(bytes, offset + 4);
    offset += kChunkHeaderBytes;
    if (size > bytes.size() - offset) {
      return source.refuse(
          fmt::format("chunk {}", chunk),
          fmt::format("it has {} bytes and {} are left in the file", size, bytes.size() - offset));
    }
    if ((chunk == 0) != (type == kJsonChunk)) {
      return source.refuse(fmt::format("chunk {}", chunk), "a GLB file begins with its one JSON chunk");
    }
    const std::string_view content = bytes.substr(offset, size);
    if (chunk == 0) {
      container.json_text = content;
    } else if (type == kBinaryChunk && !container.has_binary) {
      container.binary.assign(content.begin(), content.end());
      container.has_binary = true;
    }
    offset += size;
  }
  if (container.json_text.empty()) {
    return source.refuse("chunk 0", "the JSON chunk is empty");
  }
  return container;
}

}  // namespace

Expected<GltfContainer> readGltfContainer(const GltfSource& source) {
  Expected<std::string> bytes = readFile(source.file, kMaxGltfFileBytes);
  if (!bytes) {
    return source.refuse("", bytes.error().problem, bytes.error().remedy);
  }
  if (bytes->starts_with("glTF")) {
    return takeApartGlb(source, *bytes);
  }
  if (bytes->starts_with("\xEF\xBB\xBF")) {
    bytes->erase(0, 3);
  }
  const std::size_t first = bytes->find_first_not_of(" \t\r\n");
  if (first == std::string::npos || (*bytes)[first] != '{') {
    return source.refuse("", bytes->empty() ? "the file is empty" : "it is neither glTF JSON nor a GLB file");
  }
  return GltfContainer{*std::move(bytes), {}, false};
}

}  // namespace ssrkit
