#include "image/text_painter.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/check.h"
#include "base/text.h"
#include "image/codec.h"
#include "image/colour_map.h"
#include "image/glyph_cache.h"

namespace ssrkit {

namespace fs = std::filesystem;

namespace {

std::string environment(const char* variable) {
  const char* const value = std::getenv(variable);
  return value == nullptr ? "" : value;
}

std::vector<fs::path> fontFolders() {
  const fs::path home = environment("HOME");
  const std::string data_home = environment("XDG_DATA_HOME");
  std::vector<fs::path> folders = {
      "/usr/share/fonts/truetype/dejavu",  // Debian's place, found without a search
      (data_home.empty() ? home / ".local/share" : fs::path(data_home)) / "fonts",
      home / ".fonts",
  };
  for (const std::string& folder : split(environment("XDG_DATA_DIRS"), ':')) {
    folders.push_back(fs::path(folder) / "fonts");
  }
  folders.emplace_back("/usr/share/fonts");
  folders.emplace_back("/usr/local/share/fonts");
  std::erase_if(folders, [](const fs::path& folder) { return folder.is_relative(); });
  return folders;
}

std::optional<fs::path> findFont(const std::string& file_name) {
  constexpr auto kOptions = fs::directory_options::skip_permission_denied;
  for (const fs::path& folder : fontFolders()) {
    std::error_code code;
    fs::recursive_directory_iterator entry(folder, kOptions, code);
    for (; !code && entry != fs::recursive_directory_iterator(); entry.increment(code)) {
      if (entry->path().filename() == file_name) {
        return entry->path();
      }
    }
  }
  return std::nullopt;
}

// One ASCII character for each code point.
std::string drawable(std::string_view text) {
  std::string ascii;
  for (const char byte : text) {
    const auto code = static_cast<unsigned char>(byte);
    const bool is_continuation = (code & 0xC0U) == 0x80U;
    if (!is_continuation) {
      ascii += code >= 0x20 && code < 0x7F ? byte : '?';
    }
  }
  return ascii;
}

void blit(ByteImage& picture, int x, int y, const Glyph& glyph, Rgb8 colour) {
  const int first_x = std::max(0, -x);
  const int first_y = std::max(0, -y);
  const int last_x = std::min(glyph.size.width, picture.size.width - x);
  const int last_y = std::min(glyph.size.height, picture.size.height - y);
  for (int row = first_y; row < last_y; ++row) {
    for (int column = first_x; column < last_x; ++column) {
      const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(glyph.size.width) +
                      static_cast<std::size_t>(column);
      std::uint8_t* const out = &picture.data[picture.index(x + column, y + row)];
      std::ranges::copy(blend({out[0], out[1], out[2]}, colour, glyph.coverage[at] / 255.0), out);
    }
  }
}

}  // namespace

Expected<TextPainter> TextPainter::load() {
  const std::optional<fs::path> regular = findFont("DejaVuSans.ttf");
  const std::optional<fs::path> bold = findFont("DejaVuSans-Bold.ttf");
  if (!regular || !bold) {
    return setupError("draw text into pictures", "the font DejaVu Sans is not installed", {},
                      "install the package fonts-dejavu-core");
  }
  if (const auto codec = imageCodec(); !codec) {
    return tl::make_unexpected(codec.error());
  }
  return TextPainter(std::make_unique<GlyphCache>(regular->string()),
                     std::make_unique<GlyphCache>(bold->string()));
}

TextPainter::TextPainter(std::unique_ptr<GlyphCache> regular, std::unique_ptr<GlyphCache> bold)
    : regular_(std::move(regular)), bold_(std::move(bold)) {}
TextPainter::~TextPainter() = default;
TextPainter::TextPainter(TextPainter&&) noexcept = default;
TextPainter& TextPainter::operator=(TextPainter&&) noexcept = default;

GlyphCache& TextPainter::cacheFor(TextWeight weight) {
  return weight == TextWeight::kBold ? *bold_ : *regular_;
}

void TextPainter::draw(ByteImage& picture, int x, int baseline_y, std::string_view text,
                       const TextStyle& style) {
  SSRKIT_CHECK_LE(3, picture.channel_count);
  for (const char character : drawable(text)) {
    const Glyph& glyph = cacheFor(style.weight).glyph(character, style.height_px);
    blit(picture, x + glyph.left_px, baseline_y + glyph.top_px, glyph, style.colour);
    x += glyph.advance_px;
  }
}

int TextPainter::widthOf(std::string_view text, const TextStyle& style) {
  int width = 0;
  for (const char character : drawable(text)) {
    width += cacheFor(style.weight).glyph(character, style.height_px).advance_px;
  }
  return width;
}

}  // namespace ssrkit
