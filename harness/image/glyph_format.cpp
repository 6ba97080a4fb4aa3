#include <ft2build.h>
#include FT_FREETYPE_H

#include <algorithm>
#include <cstddef>
#include <map>
#include <mutex>

#include "image/picture_formats.h"

namespace ssrkit {

namespace {

// Faces that have been opened, null where a file is no font. They live as long as the process; FreeType wants
// one thread at a time.
class Faces {
 public:
  FT_Face find(const std::string& font_file) {
    const auto [entry, is_new] = faces_.try_emplace(font_file, nullptr);
    if (is_new && (library_ != nullptr || FT_Init_FreeType(&library_) == 0)) {
      FT_New_Face(library_, font_file.c_str(), 0, &entry->second);
    }
    return entry->second;
  }

 private:
  FT_Library library_ = nullptr;
  std::map<std::string, FT_Face> faces_;
};

Glyph glyphOf(const FT_GlyphSlotRec& slot) {
  constexpr int kPerPixel = 64;  // advances are in 26.6 fixed point
  Glyph glyph;
  glyph.advance_px = static_cast<int>(slot.advance.x / kPerPixel);
  glyph.left_px = slot.bitmap_left;
  glyph.top_px = -slot.bitmap_top;
  glyph.size = Size{static_cast<int>(slot.bitmap.width), static_cast<int>(slot.bitmap.rows)};
  const std::size_t width = slot.bitmap.width;
  glyph.coverage.resize(width * slot.bitmap.rows);
  for (std::size_t row = 0; row < slot.bitmap.rows; ++row) {
    const unsigned char* const from =
        slot.bitmap.buffer + static_cast<std::ptrdiff_t>(row) * slot.bitmap.pitch;
    std::copy_n(from, width, glyph.coverage.begin() + static_cast<std::ptrdiff_t>(row * width));
  }
  return glyph;
}

}  // namespace

Glyph renderGlyph(char character, int height_px, const std::string& font_file) {
  static std::mutex mutex;
  static Faces faces;
  const std::lock_guard lock(mutex);
  FT_Face const face = faces.find(font_file);
  const bool is_rendered = face != nullptr &&
                           FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(height_px)) == 0 &&
                           FT_Load_Char(face, static_cast<unsigned char>(character), FT_LOAD_RENDER) == 0;
  return is_rendered ? glyphOf(*face->glyph) : Glyph{};
}

}  // namespace ssrkit
