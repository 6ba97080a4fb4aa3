#include "device/gl/gl_formats.h"

#include "base/check.h"

namespace ssrkit {

GlFormat glFormat(Format format) {
  switch (format) {
    case Format::kR8ui:
      return {GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE};
    case Format::kRgba8:
      return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
    case Format::kRgba8Srgb:
      return {GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE};
    case Format::kRg16i:
      return {GL_RG16I, GL_RG_INTEGER, GL_SHORT};
    case Format::kRgba16ui:
      return {GL_RGBA16UI, GL_RGBA_INTEGER, GL_UNSIGNED_SHORT};
    case Format::kRgba16f:
      return {GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT};
    case Format::kR32f:
      return {GL_R32F, GL_RED, GL_FLOAT};
    case Format::kRg32f:
      return {GL_RG32F, GL_RG, GL_FLOAT};
    case Format::kRgba32f:
      return {GL_RGBA32F, GL_RGBA, GL_FLOAT};
    case Format::kD32f:
      return {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT};
  }
  SSRKIT_CHECK(false);
}

}  // namespace ssrkit
