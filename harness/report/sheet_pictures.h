// The pictures of a contact sheet's cells, shrunk by whole factors to about 320 texels a side.
#pragma once

#include <span>

#include "base/size.h"
#include "check/verdict.h"
#include "image/byte_image.h"
#include "image/image.h"
#include "image/ray_record.h"
#include "report/heat_scale.h"

namespace ssrkit {

// How an image becomes a cell: `shrink` x `shrink` texels become one dot, or one texel becomes `grow` x
// `grow` dots. One of the two is 1.
struct CellScale {
  int shrink = 1;
  int grow = 1;
  Size picture;  // of the functions below, not yet grown
  [[nodiscard]] Size cell() const { return {picture.width * grow, picture.height * grow}; }
};

// At most 320 dots a side; tiny images grow at most four times.
[[nodiscard]] CellScale cellScaleFor(Size size);

// Linear light, averaged over each box of `scale.shrink` texels a side, then exposed and encoded.
[[nodiscard]] ByteImage lightPicture(const Image& linear, const CellScale& scale, double exposure);

// Dark and grey, for colours to stand out on.
[[nodiscard]] ByteImage dimmed(const ByteImage& light);

// The worst verdict of each box over `backdrop`; SAME lets half of the backdrop through.
[[nodiscard]] ByteImage verdictPicture(std::span<const Verdict> verdicts, Size size, const CellScale& scale,
                                       const ByteImage& backdrop);

// The mean lookup count of each box's traced rays over `backdrop`.
[[nodiscard]] ByteImage heatPicture(const RayRecord& record, const CellScale& scale, const HeatScale& heat,
                                    const ByteImage& backdrop);

}  // namespace ssrkit
