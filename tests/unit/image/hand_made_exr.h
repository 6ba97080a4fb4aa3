// An EXR file put together byte by byte from the published file layout, uncompressed, so that what the kit
// reads is held against something that OpenImageIO did not write.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace ssrkit::testing {

enum class PixelType : std::uint32_t { kUint = 0, kHalf = 1, kFloat = 2 };

struct HandMadeChannel {
  std::string name;  // the layout wants them in alphabetical order
  PixelType type = PixelType::kFloat;
  std::vector<std::uint32_t> bits;  // one value a texel, row by row; the low 16 bits for halves
  std::int32_t sampling = 1;
};

struct HandMadeExr {
  std::int32_t width = 1;
  std::int32_t height = 1;
  std::int32_t display_width = 0;  // 0: as the data
  std::uint32_t version = 2;       // flags included
  std::vector<HandMadeChannel> channels;

  [[nodiscard]] std::string bytes() const {
    std::string file;
    append(file, std::uint32_t{20000630});
    append(file, version);
    appendHeader(file);
    const std::string rows = rowsAfter(file.size() + 8 * static_cast<std::size_t>(height));
    return file + rows;
  }

 private:
  template <class T>
  static void append(std::string& out, const T& value) {
    out.append(reinterpret_cast<const char*>(&value), sizeof(T));
  }

  static void attribute(std::string& out, const std::string& key, const std::string& type,
                        const std::string& value) {
    out += key + '\0' + type + '\0';
    append(out, static_cast<std::uint32_t>(value.size()));
    out += value;
  }

  static std::string box(std::int32_t box_width, std::int32_t box_height) {
    std::string value;
    for (const std::int32_t corner : {0, 0, box_width - 1, box_height - 1}) {
      append(value, corner);
    }
    return value;
  }

  void appendHeader(std::string& out) const {
    std::string list;
    for (const HandMadeChannel& channel : channels) {
      list += channel.name + '\0';
      append(list, channel.type);
      append(list, std::uint32_t{0});
      append(list, channel.sampling);
      append(list, channel.sampling);
    }
    std::string one_and_zeros;
    append(one_and_zeros, 1.0F);
    attribute(out, "channels", "chlist", list + '\0');
    attribute(out, "compression", "compression", std::string(1, '\0'));
    attribute(out, "dataWindow", "box2i", box(width, height));
    attribute(out, "displayWindow", "box2i", box(display_width == 0 ? width : display_width, height));
    attribute(out, "lineOrder", "lineOrder", std::string(1, '\0'));
    attribute(out, "pixelAspectRatio", "float", one_and_zeros);
    attribute(out, "screenWindowCenter", "v2f", std::string(8, '\0'));
    attribute(out, "screenWindowWidth", "float", one_and_zeros);
    out += '\0';
  }

  // The table of offsets and the scan lines: in each line, channel after channel.
  [[nodiscard]] std::string rowsAfter(std::size_t first_offset) const {
    std::string offsets;
    std::string rows;
    for (std::int32_t y = 0; y < height; ++y) {
      append(offsets, static_cast<std::uint64_t>(first_offset + rows.size()));
      std::string line;
      for (const HandMadeChannel& channel : channels) {
        for (std::int32_t x = 0; x < width; ++x) {
          const std::uint32_t value = channel.bits.at(
              static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
          line.append(reinterpret_cast<const char*>(&value), channel.type == PixelType::kHalf ? 2 : 4);
        }
      }
      append(rows, y);
      append(rows, static_cast<std::uint32_t>(line.size()));
      rows += line;
    }
    return offsets + rows;
  }
};

}  // namespace ssrkit::testing
