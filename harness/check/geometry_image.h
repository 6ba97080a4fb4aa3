// oracle/geometry.exr (docs/formats.md).
#pragma once

#include <span>

#include "check/geometry_verdict.h"
#include "image/image.h"

namespace ssrkit {

// The channels class, px.x, px.y, t_m, dist_view and verdict; `verdicts` are Oracle A's.
[[nodiscard]] Image toImage(const GeometryResult& geometry, std::span<const GeometryVerdict> verdicts);

}  // namespace ssrkit
