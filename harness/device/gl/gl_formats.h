#pragma once

#include <glad/gl.h>

#include "device/device.h"

namespace ssrkit {

struct GlFormat {
  GLenum internal;   // sized
  GLenum transfer;   // of upload and read
  GLenum component;  // type of one component in memory
};

[[nodiscard]] GlFormat glFormat(Format format);

}  // namespace ssrkit
