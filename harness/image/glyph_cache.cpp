#include "image/glyph_cache.h"

#include "image/codec.h"

namespace ssrkit {

const Glyph& GlyphCache::glyph(char character, int height_px) {
  const auto [entry, is_new] = glyphs_.try_emplace({character, height_px});
  if (is_new) {
    const auto codec = imageCodec();  // TextPainter::load has seen it loaded
    entry->second = codec ? (*codec)->renderGlyph(character, height_px, font_file_) : Glyph{};
  }
  return entry->second;
}

}  // namespace ssrkit
