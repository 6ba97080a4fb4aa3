// Where the texels of a failed check are, small enough to keep one for each failure of a run.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/size.h"
#include "check/measurement.h"

namespace ssrkit {

// Draws findings of an image of `size` into a map of at most 160 x 90 dots. A dot that stands for several
// texels shows the worst of them. Severities are by their rank among the findings, so that one huge error
// does not hide the others.
[[nodiscard]] FindingMap findingMap(Size size, std::span<const Finding> findings);

}  // namespace ssrkit
