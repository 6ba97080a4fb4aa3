// Where a frame's G-buffer comes from: the scene's triangles, or images made by others.
#pragma once

#include <map>
#include <string>

#include "base/error.h"
#include "device/device.h"
#include "frame/frame_images.h"
#include "frame/programs.h"
#include "frame/scene_resources.h"
#include "image/image.h"
#include "scene/scene.h"
#include "spaces/camera.h"

namespace ssrkit {

// Its last target is `dist_range`.
[[nodiscard]] const PassRow& gbufferPass();

// As a scene's frame draws it. In the place of `pyramid_base` or of itself by a shader of one's own it has no
// `dist_range`: the pyramid's base is drawn from dist_view then, and nobody's G-buffer shader needs to know
// of pyramids.
[[nodiscard]] PassRow gbufferPassFor(const CompileSettings& settings, const Scene& scene);

// Draws the scene into the G-buffer images, and into `dist_range` where the program's pass has it.
[[nodiscard]] Expected<PassTime> drawGbuffer(Device& device, const Program& program, const Scene& scene,
                                             const SceneResources& resources, FrameImages& images,
                                             const UniformValues& values);

// Uploads images made by others; what is missing gets its default, and depth_window what the camera's
// rasteriser would have stored for dist_view (beyond its far plane: background).
[[nodiscard]] Expected<void> uploadGbuffer(Device& device, const std::map<std::string, Image>& gbuffer,
                                           const Camera& camera, FrameImages& images);

// The uniforms that depend on the camera alone.
void setCameraUniforms(UniformValues& values, const Camera& camera);

}  // namespace ssrkit
