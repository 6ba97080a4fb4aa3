// Coverage masks of single characters of one font at several sizes, made when first asked for.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/size.h"

namespace ssrkit {

struct Glyph {
  int advance_px = 0;  // from this character's origin to the next one's
  int left_px = 0;     // of the mask's upper left corner, from the origin on the base line
  int top_px = 0;
  Size size;
  std::vector<std::uint8_t> coverage;  // 255: ink
};

class GlyphCache {
 public:
  explicit GlyphCache(std::string font_file) : font_file_(std::move(font_file)) {}

  // `character` is printable ASCII.
  [[nodiscard]] const Glyph& glyph(char character, int height_px);

 private:
  std::string font_file_;
  std::map<std::pair<char, int>, Glyph> glyphs_;
};

}  // namespace ssrkit
