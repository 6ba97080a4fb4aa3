// The camera, the parameters and the G-buffer of a job that is looked at in another way.
#pragma once

#include "frame/job.h"
#include "image/view_change.h"
#include "spaces/camera.h"
#include "spaces/trace_parameters.h"

namespace ssrkit {

// Mirroring and scaling are the first thing that view_from_world does, so that all of view space is mirrored
// (its x is to the left then) or scaled; a crop is an off-centre projection.
[[nodiscard]] Camera cameraIn(const ViewChange& view, const Camera& camera);

// Lengths in metres are scaled.
[[nodiscard]] TraceParameters parametersIn(const ViewChange& view, const TraceParameters& parameters);

// Its traces' parameters, and the G-buffer with its camera where they were given. The size stays the whole
// picture's, and the camera of a scene is left to whoever loads it.
[[nodiscard]] Job jobIn(const ViewChange& view, Job job);

}  // namespace ssrkit
