#pragma once

#include <cstddef>
#include <utility>

#include "device/device.h"
#include "device/gl/gl_object.h"

namespace ssrkit {

class GlVertexBuffer final : public DeviceBuffer {
 public:
  GlVertexBuffer(GlObject buffer, std::size_t byte_count)
      : buffer_(std::move(buffer)), byte_count_(byte_count) {}

  [[nodiscard]] GLuint buffer() const { return buffer_.name(); }
  [[nodiscard]] std::size_t byteCount() const { return byte_count_; }

 private:
  GlObject buffer_;
  std::size_t byte_count_;
};

}  // namespace ssrkit
