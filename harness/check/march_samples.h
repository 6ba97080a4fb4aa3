// Where on the image a march takes its samples, from the contract alone (docs/spaces.md): a second account of
// what the shaders do, in double precision, for the metrics that judge how a march spends its lookups.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "image/ray_record.h"
#include "oracle/image_ray.h"
#include "spaces/trace_parameters.h"

namespace ssrkit {

// Where the ray is after t_m metres.
[[nodiscard]] double sigmaAtMetres(const ImageRay& ray, double t_m);
// The length of the ray; one that runs to its vanishing point inside the image ends half a pixel before it.
[[nodiscard]] double lengthMetres(const ImageRay& ray);

// How a stage goes along a ray: by metres, or by columns (or rows) of the image.
enum class MarchSpacing { kMetres, kColumns };

// By the stage's name; none where its samples follow what was found (hiz) or where they are not evenly
// spaced.
[[nodiscard]] std::optional<MarchSpacing> marchSpacing(std::string_view stage);

// The texels of the march's samples in order, without the bisections that refine a hit: as many as the record
// says that the ray took. The ray must have been walked; the parameters hold the stage's defaults, and no
// jitter.
[[nodiscard]] std::vector<glm::ivec2> marchSamples(MarchSpacing spacing, const ImageRay& ray,
                                                   const TraceParameters& parameters, const RayHit& hit);

}  // namespace ssrkit
