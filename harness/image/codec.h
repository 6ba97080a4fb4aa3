// What the kit asks of OpenEXR, libpng and FreeType, as a table of functions that is loaded at the first use:
// workers and most commands read and write no picture, so only a module of its own is linked to them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/size.h"
#include "image/byte_image.h"
#include "image/glyph_cache.h"
#include "image/image.h"

namespace ssrkit {

inline constexpr int kMaxImageChannels = 1024;
inline constexpr long long kMaxImageBytes = 2LL << 30;  // decoded

// Every function but `renderGlyph` returns what is wrong, or an empty text. May be called from several
// threads.
struct ImageCodec {
  std::string (*encodeExr)(const Image& image, const std::map<std::string, std::string>& metadata,
                           std::vector<unsigned char>& bytes);
  // `image` has the size and channels to be read; its data is filled.
  std::string (*decodeExr)(const std::string& file, Image& image);
  std::string (*encodePng)(const ByteImage& image, std::vector<unsigned char>& bytes);
  Glyph (*renderGlyph)(char character, int height_px, const std::string& font_file);
};

// Loads the module at the first call. Fails when it or one of its libraries is not installed.
[[nodiscard]] Expected<const ImageCodec*> imageCodec();

// The module's only symbol.
using ImageCodecFunction = const ImageCodec*();
inline constexpr const char* kImageCodecSymbol = "ssrkitImageCodec";

}  // namespace ssrkit
