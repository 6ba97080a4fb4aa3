#include "image/exr_header.h"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>

#include "image/codec.h"

namespace ssrkit {

namespace {

static_assert(std::endian::native == std::endian::little, "EXR integers are little-endian");

constexpr std::uint32_t kMagic = 20000630;
constexpr std::uint32_t kDeepFlag = 0x800;
constexpr std::uint32_t kMultiPartFlag = 0x1000;
constexpr std::uint32_t kUintPixels = 0;

// Takes values off the front of the bytes; every read past the end fails instead.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  template <class T>
  std::optional<T> value() {
    T result{};
    if (bytes_.size() < sizeof(T)) {
      return std::nullopt;
    }
    std::memcpy(&result, bytes_.data(), sizeof(T));
    bytes_.remove_prefix(sizeof(T));
    return result;
  }

  std::optional<std::string_view> take(std::size_t count) {
    if (bytes_.size() < count) {
      return std::nullopt;
    }
    const std::string_view taken = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return taken;
  }

  // Up to the next zero byte, which is dropped.
  std::optional<std::string_view> text() {
    const std::size_t end = bytes_.find('\0');
    if (end == std::string_view::npos) {
      return std::nullopt;
    }
    const std::string_view taken = bytes_.substr(0, end);
    bytes_.remove_prefix(end + 1);
    return taken;
  }

 private:
  std::string_view bytes_;
};

struct Box {
  std::int32_t x_min, y_min, x_max, y_max;
  bool operator==(const Box&) const = default;
};

struct ChannelTail {
  std::uint32_t pixel_type;
  std::uint32_t linear_and_reserved;
  std::int32_t x_sampling, y_sampling;
};

bool readChannels(std::string_view bytes, ExrHeader& header) {
  ByteReader reader(bytes);
  while (true) {
    const auto channel = reader.text();
    if (!channel) {
      return false;
    }
    if (channel->empty()) {
      return !header.channels.empty();
    }
    const auto tail = reader.value<ChannelTail>();
    if (!tail || header.channels.size() >= kMaxImageChannels) {
      return false;
    }
    header.channels.emplace_back(*channel);
    if (tail->pixel_type == kUintPixels) {
      header.integer_channels.emplace_back(*channel);
    }
    header.has_subsampled_channel |= tail->x_sampling != 1 || tail->y_sampling != 1;
  }
}

struct Windows {
  std::optional<Box> data;
  std::optional<Box> display;
};

bool readAttributes(ByteReader& reader, ExrHeader& header, Windows& windows) {
  while (true) {
    const auto attribute = reader.text();
    if (!attribute || attribute->empty()) {
      return attribute.has_value();
    }
    const auto type = reader.text();
    const auto byte_count = reader.value<std::uint32_t>();
    const auto bytes = byte_count ? reader.take(*byte_count) : std::nullopt;
    if (!type || !bytes) {
      return false;
    }
    if (*attribute == "channels" && header.channels.empty() && !readChannels(*bytes, header)) {
      return false;
    }
    if (*attribute == "dataWindow") {
      windows.data = ByteReader(*bytes).value<Box>();
    }
    if (*attribute == "displayWindow") {
      windows.display = ByteReader(*bytes).value<Box>();
    }
  }
}

// Empty when all is well.
std::string takeSize(const Windows& windows, ExrHeader& header) {
  if (!windows.data || !windows.display || header.channels.empty()) {
    return "its header is incomplete";
  }
  const Box& box = *windows.data;
  const std::int64_t width = std::int64_t{box.x_max} - box.x_min + 1;
  const std::int64_t height = std::int64_t{box.y_max} - box.y_min + 1;
  if (width < 1 || height < 1 || width > kMaxImageSide || height > kMaxImageSide) {
    return fmt::format("it claims {} x {} texels, and the kit reads 1 to {} on a side", width, height,
                       kMaxImageSide);
  }
  header.size = Size{static_cast<int>(width), static_cast<int>(height)};
  header.is_crop = !(box == *windows.display);
  return {};
}

}  // namespace

bool readExrHeader(std::string_view file, ExrHeader& header, std::string& problem) {
  ByteReader reader(file);
  const auto magic = reader.value<std::uint32_t>();
  const auto version = reader.value<std::uint32_t>();
  if (!magic || *magic != kMagic || !version) {
    problem = "it is not an EXR file";
    return false;
  }
  if ((*version & kMultiPartFlag) != 0 || (*version & kDeepFlag) != 0) {
    problem = (*version & kDeepFlag) != 0 ? "it holds deep data" : "it holds several parts";
    return false;
  }
  Windows windows;
  if (!readAttributes(reader, header, windows)) {
    problem = "its header is damaged";
    return false;
  }
  problem = takeSize(windows, header);
  return problem.empty();
}

}  // namespace ssrkit
