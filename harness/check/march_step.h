// How long the steps of a march are, from the contract alone: what a hit that lies between two samples may be
// wrong by.
#pragma once

#include <optional>
#include <string_view>

#include "oracle/image_ray.h"
#include "spaces/trace_parameters.h"

namespace ssrkit {

// How the steps of a stage follow one another along a ray.
enum class StepKind {
  kPoints,       // of one length in metres; a sample meets the columns that it lies in
  kMetres,       // of one length in metres; as all others, the whole step is held against a column
  kExponential,  // in metres, each step_growth times the one before; step_count of them make the ray
  kAdaptive,     // in metres, each at most step_growth times the one before
  kPixels,       // stride_px along the longer axis
  kCapped,       // so, or longer where step_count steps make the ray
};

// By the stage's name, with or without what follows its first '_'; none where it does not step (hiz, walk).
[[nodiscard]] std::optional<StepKind> stepKind(std::string_view stage);

// Where the step that ends at `sigma` began at the earliest, not before the ray's origin, and where the one
// that begins at `sigma` ends at the latest, be it beyond the ray's end: sigmas too. The parameters hold the
// stage's defaults.
[[nodiscard]] double stepStart(StepKind kind, const ImageRay& ray, const TraceParameters& parameters,
                               double sigma);
[[nodiscard]] double stepEnd(StepKind kind, const ImageRay& ray, const TraceParameters& parameters,
                             double sigma);

// Where a march ends: where its ray does, but not within half a pixel of a vanishing point. One that counts
// in pixels then ends half a pixel before its ray.
[[nodiscard]] double marchEnd(StepKind kind, const ImageRay& ray);

}  // namespace ssrkit
