// The functions of the module (image/codec.h), by the library that each is made of. Not for the program.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "image/byte_image.h"
#include "image/glyph_cache.h"
#include "image/image.h"

namespace ssrkit {

// exr_format.cpp: OpenEXR.
[[nodiscard]] std::string encodeExr(const Image& image, const std::map<std::string, std::string>& metadata,
                                    std::vector<unsigned char>& bytes);
[[nodiscard]] std::string decodeExr(const std::string& file, Image& image);

// png_format.cpp: libpng.
[[nodiscard]] std::string encodePng(const ByteImage& image, std::vector<unsigned char>& bytes);

// glyph_format.cpp: FreeType.
[[nodiscard]] Glyph renderGlyph(char character, int height_px, const std::string& font_file);

}  // namespace ssrkit
