// A scene file on a device, where a frame of a sequence has it.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "base/error.h"
#include "device/device.h"
#include "frame/job.h"
#include "frame/scene_resources.h"
#include "frame/uniform_values.h"
#include "scene/scene.h"

namespace ssrkit {

struct PosedScene {
  Scene scene;
  SceneResources resources;
  int shadow_cascade_count = 1;
};

// Loads the job's scene file and uploads it.
[[nodiscard]] Expected<PosedScene> loadPosedScene(Device& device, const Job& job);

// Puts everything where `frame` of the job's sequence has it, and sets the uniforms of its camera and lights.
[[nodiscard]] Expected<Camera> poseForFrame(Device& device, const Job& job, int frame, PosedScene& posed,
                                            UniformValues& values);

}  // namespace ssrkit
