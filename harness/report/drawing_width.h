// The drawings of a report's page are all as wide, so that they stand below each other without a step.
#pragma once

namespace ssrkit {

inline constexpr double kDrawingWidth = 900.0;  // of the SVG's own units; a narrow page shows them smaller

}  // namespace ssrkit
