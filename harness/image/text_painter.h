// Writes short lines of text into pictures.
#pragma once

#include <memory>
#include <string_view>

#include "base/error.h"
#include "image/byte_image.h"

namespace ssrkit {

class GlyphCache;

enum class TextWeight { kRegular, kBold };

struct TextStyle {
  int height_px = 14;  // of the font's body, as in "14 px text"
  Rgb8 colour = {0, 0, 0};
  TextWeight weight = TextWeight::kRegular;
};

// Keeps the characters it has drawn: make one and use it for many pictures. For one thread at a time.
class TextPainter {
 public:
  // Looks for DejaVu Sans in the folders where systems keep fonts ($XDG_DATA_HOME, $XDG_DATA_DIRS,
  // /usr/share, /usr/local/share, ~/.fonts). A set-up error that names the package when there is none.
  [[nodiscard]] static Expected<TextPainter> load();

  ~TextPainter();
  TextPainter(TextPainter&&) noexcept;
  TextPainter& operator=(TextPainter&&) noexcept;

  // `text` is UTF-8; what is not ASCII is drawn as '?'. What falls
  // outside the picture is cut off.
  void draw(ByteImage& picture, int x, int baseline_y, std::string_view text, const TextStyle& style);

  [[nodiscard]] int widthOf(std::string_view text, const TextStyle& style);

 private:
  TextPainter(std::unique_ptr<GlyphCache> regular, std::unique_ptr<GlyphCache> bold);
  GlyphCache& cacheFor(TextWeight weight);

  std::unique_ptr<GlyphCache> regular_;
  std::unique_ptr<GlyphCache> bold_;
};

}  // namespace ssrkit
