#pragma once

#include <memory>

#include "base/error.h"
#include "device/device.h"
#include "device/gl/gl_samplers.h"
#include "device/gl/gl_session.h"
#include "device/gl/gl_timestamps.h"

namespace ssrkit {

// Clears, draws and waits. The time covers the clears and the draws, not the making of framebuffer and
// uniforms.
[[nodiscard]] Expected<PassTime> drawGlPass(const std::shared_ptr<GlSession>& session, GlSamplers& samplers,
                                            GlTimestamps& timestamps, const PassDesc& pass);

}  // namespace ssrkit
