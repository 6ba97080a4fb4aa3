#include "image/glyph_cache.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include "image/oiio_setup.h"

namespace ssrkit {

namespace {

// OpenImageIO tells a text's inked box but not a character's advance: the box of "X|" ends that much further
// right than the box of "|".
int advanceOf(const std::string& character, int height_px, const std::string& font_file) {
  const OIIO::ROI bar = OIIO::ImageBufAlgo::text_size("|", height_px, font_file);
  const OIIO::ROI both = OIIO::ImageBufAlgo::text_size(character + "|", height_px, font_file);
  return bar.defined() && both.defined() ? both.xend - bar.xend : 0;
}

Glyph render(const std::string& character, int height_px, const std::string& font_file) {
  setUpOiio();
  Glyph glyph;
  glyph.advance_px = advanceOf(character, height_px, font_file);
  const OIIO::ROI box = OIIO::ImageBufAlgo::text_size(character, height_px, font_file);
  if (!box.defined() || box.width() < 1 || box.height() < 1) {
    return glyph;
  }
  constexpr int kMargin = 1;  // the box is of whole pixels and smoothing may reach past it
  glyph.left_px = box.xbegin - kMargin;
  glyph.top_px = box.ybegin - kMargin;
  glyph.size = Size{box.width() + 2 * kMargin, box.height() + 2 * kMargin};
  OIIO::ImageBuf mask(OIIO::ImageSpec(glyph.size.width, glyph.size.height, 1, OIIO::TypeDesc::UINT8),
                      OIIO::InitializePixels::Yes);
  if (!OIIO::ImageBufAlgo::render_text(mask, -glyph.left_px, -glyph.top_px, character, height_px,
                                       font_file)) {
    return Glyph{};
  }
  glyph.coverage.resize(static_cast<std::size_t>(glyph.size.width) *
                        static_cast<std::size_t>(glyph.size.height));
  mask.get_pixels(mask.roi(), OIIO::TypeDesc::UINT8, glyph.coverage.data());
  return glyph;
}

}  // namespace

const Glyph& GlyphCache::glyph(char character, int height_px) {
  const auto [entry, is_new] = glyphs_.try_emplace({character, height_px});
  if (is_new) {
    entry->second = render(std::string(1, character), height_px, font_file_);
  }
  return entry->second;
}

}  // namespace ssrkit
