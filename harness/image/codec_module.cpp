// The module's only symbol (image/codec.h).
#include "image/codec.h"
#include "image/picture_formats.h"

extern "C" const ssrkit::ImageCodec* ssrkitImageCodec() {
  static const ssrkit::ImageCodec codec{.encodeExr = ssrkit::encodeExr,
                                        .decodeExr = ssrkit::decodeExr,
                                        .encodePng = ssrkit::encodePng,
                                        .renderGlyph = ssrkit::renderGlyph};
  return &codec;
}
