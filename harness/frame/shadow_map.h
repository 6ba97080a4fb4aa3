// The shadow map of the scene's first directional light: a geometry pass into one image of depths.
#pragma once

#include "base/error.h"
#include "device/device.h"
#include "frame/frame_images.h"
#include "frame/programs.h"
#include "frame/scene_resources.h"
#include "scene/scene.h"
#include "spaces/camera.h"

namespace ssrkit {

// Casters that cover all of their triangles, and those with an alpha cutoff. Most have none, and are drawn
// four times as fast by a shader that never discards.
[[nodiscard]] const PassRow& shadowMapPass();
[[nodiscard]] const PassRow& shadowMapMaskedPass();

struct ShadowMapPrograms {
  const Program* opaque = nullptr;
  const Program* masked = nullptr;
};
[[nodiscard]] Expected<ShadowMapPrograms> shadowMapPrograms(Programs& programs,
                                                            const CompileSettings& settings);

// Sets the uniforms of whoever draws or reads the map, and says how many cascades it has. A scene without a
// directional light has a map that nothing reads.
[[nodiscard]] int setShadowUniforms(UniformValues& values, const Scene& scene, const Camera& camera);

// Draws the cascades side by side into the image `shadow_map`. The time is the sum of their passes.
[[nodiscard]] Expected<PassTime> drawShadowMap(Device& device, const ShadowMapPrograms& programs,
                                               int cascade_count, const Scene& scene,
                                               const SceneResources& resources, FrameImages& images,
                                               const UniformValues& values);

// A map in which nothing casts a shadow, for frames without a scene.
[[nodiscard]] Expected<void> clearShadowMap(Device& device, FrameImages& images);

}  // namespace ssrkit
