// A picture looked at in another way: what becomes of its texels. The geometry before the camera stays what
// it is.
#pragma once

#include <string>

#include "base/size.h"
#include "image/image.h"
#include "image/ray_record.h"

namespace ssrkit {

struct ViewChange {
  bool is_mirrored = false;  // left and right change places: texel x becomes width - 1 - x
  double scale = 1.0;        // everything is so many times as large and as far away; a power of two
  bool is_cropped = false;   // to cropOf(size)

  bool operator==(const ViewChange&) const = default;
};

// An image's part, by its upper left texel.
struct Crop {
  int x = 0;
  int y = 0;
  Size size;
};

// Not centred, and of other proportions: an eighth off the left and a tenth off the right, a sixth off the
// top and a ninth off the bottom.
[[nodiscard]] Crop cropOf(Size size);
[[nodiscard]] Size sizeIn(const ViewChange& view, Size size);

// The image of that name (a row of frame/frame_images.h) as the view has it: distances are scaled, the x of
// normals and motion turned.
[[nodiscard]] Image imageIn(const ViewChange& view, const std::string& name, const Image& image);

// The rays as the view has them. In a cropped one a ray that hit outside has left the image. What a crop
// cannot tell: whether a ray that ended by its range or budget had left it before.
[[nodiscard]] RayRecord recordIn(const ViewChange& view, const RayRecord& record);

}  // namespace ssrkit
