// FLIP: how different two pictures look to somebody who flips between them.
//
// Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom and Fairchild, "FLIP: A Difference Evaluator for
// Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020. Section 4.1 filters by the eye's
// contrast sensitivity and measures what is left of the colours' difference, section 4.2 finds edges and
// points that come or go, section 4.3 joins the two.
#pragma once

#include "image/image.h"

namespace ssrkit {

// The paper's observer: 0.7 m before a screen 0.7 m and 3840 pixels wide.
inline constexpr double kFlipPixelsPerDegree = 67.0206432765823;  // 3840 pi / 180

// One channel, "flip": 0 where nobody sees a difference, nearly 1 (0.967) where black meets white. The
// pictures are linear light with at least three channels (or one, grey), clamped to 0..1 as a screen does it;
// what is not a number counts as 0. Both have the same size and channels, and at least one texel (checked).
[[nodiscard]] Image flipMap(const Image& reference, const Image& test,
                            double pixels_per_degree = kFlipPixelsPerDegree);

}  // namespace ssrkit
