#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "device/device.h"
#include "frame/frame_images.h"
#include "frame/job.h"
#include "frame/uniform_values.h"
#include "scene/scene.h"

namespace ssrkit {

// A G-buffer made by others brings no lights: one from above and behind the camera, under the default sky.
[[nodiscard]] const Scene& sceneOfGiven();

// Uploads a job's G-buffer that others made, and sets the uniforms of its camera and of a light for it. The
// names of the images beyond the G-buffer's that were given: what would draw them is left out.
[[nodiscard]] Expected<std::vector<std::string>> uploadGiven(Device& device, const Job& job,
                                                             FrameImages& images, UniformValues& values);

}  // namespace ssrkit
