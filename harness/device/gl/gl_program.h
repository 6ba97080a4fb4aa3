#pragma once

#include <memory>

#include "base/error.h"
#include "device/device.h"
#include "device/gl/gl_object.h"
#include "device/pass_rules.h"

namespace ssrkit {

class GlProgram final : public DeviceProgram {
 public:
  // Loads, specialises and links. A failure carries the driver's log in its reasons.
  [[nodiscard]] static Expected<std::unique_ptr<GlProgram>> create(const std::shared_ptr<GlSession>& session,
                                                                   const ProgramDesc& desc);

  [[nodiscard]] const ProgramLayout& layout() const { return layout_; }
  [[nodiscard]] GLuint program() const { return program_.name(); }
  [[nodiscard]] GLuint vertexArray() const { return vertex_array_.name(); }

 private:
  GlProgram(ProgramLayout layout, GlObject program, GlObject vertex_array)
      : layout_(std::move(layout)), program_(std::move(program)), vertex_array_(std::move(vertex_array)) {}

  ProgramLayout layout_;
  GlObject program_;
  GlObject vertex_array_;
};

}  // namespace ssrkit
