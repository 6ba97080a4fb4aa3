// Passes that draw the scene's triangles: uniforms and textures by name, one draw for each run of one
// material.
#pragma once

#include <span>
#include <vector>

#include "base/error.h"
#include "device/device.h"
#include "frame/programs.h"
#include "frame/scene_resources.h"
#include "scene/scene.h"

namespace ssrkit {

struct GeometryPass {
  const PassRow* row = nullptr;
  std::span<const DrawRange> ranges;  // of the scene's: what is drawn
  std::vector<Attachment> colour;
  Attachment depth;
  Rect viewport;
};

[[nodiscard]] Expected<PassTime> drawGeometry(Device& device, const Program& program,
                                              const GeometryPass& pass, const Scene& scene,
                                              const SceneResources& resources, const UniformValues& values);

}  // namespace ssrkit
