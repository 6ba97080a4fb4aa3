// What the kit asks of OpenImageIO, as a table of functions that is loaded at the first use.
//
// The library brings some 260 shared libraries with it, 0.3 s of CPU time before main() for every process
// that is linked to it. Workers and most commands read and write no picture, so only image/oiio_codec.cpp is
// linked to it, as a module of its own.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/error.h"
#include "image/byte_image.h"
#include "image/glyph_cache.h"
#include "image/image.h"

namespace ssrkit {

inline constexpr int kMaxImageSide = 16384;  // texels
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
  std::string (*decodePng)(const std::string& file, ByteImage& image);  // 1 to 4 channels
  Glyph (*renderGlyph)(const std::string& character, int height_px, const std::string& font_file);
};

// Loads the module at the first call. Fails when it or OpenImageIO is not installed.
[[nodiscard]] Expected<const ImageCodec*> imageCodec();

// The module's only symbol.
using ImageCodecFunction = const ImageCodec*();
inline constexpr const char* kImageCodecSymbol = "ssrkitImageCodec";

}  // namespace ssrkit
