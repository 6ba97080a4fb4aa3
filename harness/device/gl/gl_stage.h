// One stage of a program, by the way in that the session's driver has.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "base/error.h"
#include "device/device.h"
#include "device/gl/gl_object.h"

namespace ssrkit {

struct GlStageSource {
  GLenum stage = GL_FRAGMENT_SHADER;
  const char* name = "fragment";
  std::span<const std::uint32_t> spirv;
  std::span<const std::uint32_t> constant_ids;
};

// A shader object with its specialisation constants set. Fails where the SPIR-V is broken, cannot be
// translated, or the driver refuses it, with the driver's log in the reasons.
[[nodiscard]] Expected<GlObject> loadGlStage(const std::shared_ptr<GlSession>& session,
                                             const ProgramDesc& desc, const GlStageSource& source);

// The error of shaders that the driver did not take: its log and its messages are the reasons.
[[nodiscard]] tl::unexpected<Error> refusedShaders(GlSession& session, std::string attempted,
                                                   std::string_view log);

}  // namespace ssrkit
