// LEAK: the loss that an 8-connected walk cannot avoid.
//
// An 8-connected walk visits one texel for each column of the image (each row, where the ray is steeper than
// 45 degrees): the one that holds the ray's position at the column's centre. Where the ray clips the corner
// of another texel on its way, that texel is never looked at, and a diagonal line one texel wide lets the ray
// through.
#pragma once

#include <optional>

#include "image/image.h"
#include "image/ray_record.h"
#include "oracle/image_ray.h"
#include "oracle/oracle.h"

namespace ssrkit {

// Decides rays one by one over a depth image that it copies once, for the first of them.
class LeakClassifier {
 public:
  explicit LeakClassifier(const OracleInput& input);

  // Whether `answer` is what an 8-connected walk must say of the ray of pixel (x, y): the texel that the
  // oracle hit is off its path, and once it and every further hit off the path are taken away, what remains
  // is `answer` (its texel within 1 px, for the walk tests the depths of a whole column), or a miss of the
  // class of the ray's end. A texel whose border the ray crosses within 5e-4 px of the column's centre may
  // count as on the path or off it.
  [[nodiscard]] bool isLeak(const RayHit& answer, int x, int y);

 private:
  struct TexelAt {
    int x;
    int y;
  };
  [[nodiscard]] std::optional<TexelAt> firstHit(const ImageRay& ray, int x, int y) const;

  Image depth_without_;  // dist_view with the texels off the path removed, restored after each ray
  OracleInput input_;
  PixelProjection projection_;
};

}  // namespace ssrkit
