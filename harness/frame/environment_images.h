// The environment's maps on the device, under the names that light_ggx.frag and composite_replace.frag
// sample.
#pragma once

#include <optional>

#include "base/error.h"
#include "environment/environment_maps.h"
#include "frame/frame_images.h"
#include "frame/uniform_values.h"
#include "scene/scene.h"

namespace ssrkit {

// The scene's, or the one that a job puts in its place.
[[nodiscard]] EnvironmentSource environmentSource(const Scene& scene,
                                                  const std::optional<EnvironmentChoice>& chosen);

// Images `environment` (with mips), `irradiance`, `split_sum`, and `white`, one texel that stands for a
// shadow and an occlusion that nobody made; the uniforms that say how large they are.
[[nodiscard]] Expected<void> uploadEnvironment(Device& device, const EnvironmentMaps& maps,
                                               FrameImages& images, UniformValues& values);

}  // namespace ssrkit
