// All frames of a job's sequence, with everything that is drawn in each.
#pragma once

#include <functional>
#include <vector>

#include "base/error.h"
#include "device/device.h"
#include "frame/frame_drawing.h"
#include "frame/frame_images.h"
#include "frame/job.h"
#include "frame/progress.h"
#include "frame/tracing.h"
#include "frame/uniform_values.h"

namespace ssrkit {

struct SequenceDrawing {
  Device& device;
  FrameImages& images;
  FrameDrawing& frame;
  std::vector<Tracing>& traces;
  UniformValues& values;
  const Progress& progress;
  std::function<Expected<void>(int frame)> pose;  // puts everything where that frame has it
};

// Draws `frame_count` frames, the last one once and then `rounds` times more, and adds its traces to the
// result.
[[nodiscard]] Expected<void> drawSequence(const SequenceDrawing& drawing, int frame_count, int rounds,
                                          JobResult& result);

}  // namespace ssrkit
