// The scenes whose answers are formulas: what every tracer and the oracle must give for a pixel, without
// tracing.
//
// NDC X, Y of a texel centre, +Y up; f = cot(fov_y / 2), a = width / height; rows count from the top.
//   m1  Floor y = -h is the mirror, wall at dist_view D. A reflected ray stays in its column and is seen at
//       Y_r(dist) = |Y| - 2hf / dist, so it meets the wall at Y' = |Y| - 2hf / D: the image is mirrored about
//       the row where floor and wall meet.
//   m2  Mirror facing the camera at dist_view D, floor y = -h under and behind the camera. The rays come
//   towards the
//       camera and meet the floor at dist = 2D - hf / |Y|, seen at (X, -|Y|) (2D - dist) / dist.
//   m3  m1 and a quad that floats at dist_view D_q between Y_low and Y_high. A ray with |Y| - 2hf / D_q in
//   that range
//       meets it; any other comes up behind it at dist = 2hf / (|Y| - Y_low) and hits its column there,
//       falsely, when that is less than D_q + T.
//   m4  A mirror turned by 45 degrees about y through the camera's axis at D, and a side wall x = x_w. The
//   principal
//       ray turns lateral, at constant depth, and is seen to meet the wall at X' = f x_w / (a D). Rays that
//       may meet the floor before the wall are left open.
// The rules of whole texels (a column has one depth, its centre's) are part of the answer: for each pixel one
// linear inequality gives the row or column (oracle/strip.h).
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "base/size.h"
#include "image/ray_record.h"
#include "spaces/trace_parameters.h"

namespace ssrkit {

struct Texel {
  int x = -1;
  int y = -1;
  bool operator==(const Texel&) const = default;
};

// What a pixel's ray must give. Without a class the formula does not decide, and `undecided` says why.
struct ExpectedRay {
  std::optional<RayClass> ray_class;
  Texel texel;            // of a HIT, else -1
  glm::dvec2 px{-1.0};    // of a HIT
  double dist_view = -1;  // of a HIT, metres
  int lookups = -1;       // cells walked to a HIT, else -1
  std::string undecided;
};

// One scene's formula. Its constants are those of scenes/kit/closed_form.py.
struct ClosedForm {
  std::string scene;    // "m1"
  std::string formula;  // one line for reports
  ExpectedRay (*expected)(Size size, const TraceParameters& parameters, int x, int y) = nullptr;
};

// nullptr for scenes without a closed form.
[[nodiscard]] const ClosedForm* findClosedForm(std::string_view scene);

// The same for one pixel. Undecided for other scenes, and for parameters that the formulas leave out (a
// finite max_distance_m, a bias).
[[nodiscard]] ExpectedRay expectedAt(std::string_view scene, Size size, const TraceParameters& parameters,
                                     int x, int y);

}  // namespace ssrkit
