// The image that the gloss blur and its guide are held to: a view straight ahead, over surfaces at one
// distance unless a test says otherwise.
#pragma once

#include "base/size.h"

namespace ssrkit {

inline constexpr Size kBlurSize{61, 47};
inline constexpr double kBlurPxScale = 80.0;
inline constexpr double kBlurDist = 5.0;

}  // namespace ssrkit
