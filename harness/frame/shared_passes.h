// Passes that techniques of several families draw alike.
#pragma once

#include "frame/frame_pass.h"

namespace ssrkit {

// Fetches what each ray hit: "reflection", zero where it hit nothing.
[[nodiscard]] FramePass resolvePass();

// Weighs the image "reflection" by what screen space can know of each hit: "reflection_weighed".
[[nodiscard]] FramePass confidencePass();

// Adds what one sample's ray hit to "reflected_sum" and "weight_sum", for average_arriving.
[[nodiscard]] FramePass accumulateArrivingPass();

}  // namespace ssrkit
