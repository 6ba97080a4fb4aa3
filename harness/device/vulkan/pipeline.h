// The graphics pipeline of a program.
#pragma once

#include <string>

#include "base/error.h"
#include "device/device.h"
#include "device/vulkan/gpu.h"
#include "device/vulkan/handle.h"

namespace ssrkit::vulkan {

// Triangles, nothing culled, no blending; depth as the program says; viewport and
// scissor set at draw time. A module that makes the validation layer report an error is refused before the
// driver sees it.
[[nodiscard]] Expected<Handle<VkPipeline>> makePipeline(const Gpu& gpu, const ProgramDesc& desc,
                                                        VkPipelineLayout layout,
                                                        const std::string& attempted);

}  // namespace ssrkit::vulkan
