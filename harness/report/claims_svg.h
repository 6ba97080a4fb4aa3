// A claim's figures as drawings in SVG.
#pragma once

#include <string>
#include <vector>

#include "report/claims_report.h"

namespace ssrkit {

// One for each figure's name: a bar for each answer on a scale from 0, dashed lines where it is confirmed and
// refuted, and for distributions the shares of their classes under each bar.
[[nodiscard]] std::vector<std::string> figureDrawings(const ClaimReport& report);

}  // namespace ssrkit
