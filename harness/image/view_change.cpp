#include "image/view_change.h"

#include <algorithm>

namespace ssrkit {

namespace {

// Where the view's texel (x, y) lies in the whole picture.
struct Source {
  int x;
  int y;
};

Source sourceOf(const ViewChange& view, Size whole, int x, int y) {
  const Crop crop = view.is_cropped ? cropOf(whole) : Crop{0, 0, whole};
  const int column = view.is_mirrored ? crop.size.width - 1 - x : x;
  return {crop.x + column, crop.y + y};
}

bool holds(const Crop& crop, int x, int y) {
  return x >= crop.x && x < crop.x + crop.size.width && y >= crop.y && y < crop.y + crop.size.height;
}

RayHit cropped(RayHit ray, const Crop& crop) {
  if (ray.ray_class != RayClass::kHit) {
    return ray;
  }
  if (!holds(crop, ray.texel_x, ray.texel_y)) {
    return {.ray_class = RayClass::kOffscreen, .lookups = ray.lookups, .steps = ray.steps};
  }
  ray.texel_x -= crop.x;
  ray.texel_y -= crop.y;
  ray.px_x -= static_cast<float>(crop.x);
  ray.px_y -= static_cast<float>(crop.y);
  return ray;
}

RayHit mirrored(RayHit ray, int width) {
  if (ray.ray_class == RayClass::kHit) {
    ray.texel_x = width - 1 - ray.texel_x;
    ray.px_x = static_cast<float>(width) - ray.px_x;
  }
  return ray;
}

RayHit scaled(RayHit ray, double scale) {
  if (ray.ray_class == RayClass::kHit) {
    ray.t_m = static_cast<float>(ray.t_m * scale);
  }
  return ray;
}

}  // namespace

Crop cropOf(Size size) {
  const int left = size.width / 8;
  const int top = size.height / 6;
  return {left, top, {size.width - left - size.width / 10, size.height - top - size.height / 9}};
}

Size sizeIn(const ViewChange& view, Size size) {
  return view.is_cropped ? cropOf(size).size : size;
}

Image imageIn(const ViewChange& view, const std::string& name, const Image& image) {
  Image seen(sizeIn(view, image.size), image.channels);
  const bool has_x = name == "normal_view" || name == "motion";
  const bool is_distance = name == "dist_view";
  for (int y = 0; y < seen.size.height; ++y) {
    for (int x = 0; x < seen.size.width; ++x) {
      const Source from = sourceOf(view, image.size, x, y);
      for (std::size_t channel = 0; channel < seen.channelCount(); ++channel) {
        const float value = image.at(from.x, from.y, channel);
        const bool is_turned = view.is_mirrored && has_x && channel == 0;
        const float scale = is_distance ? static_cast<float>(view.scale) : 1.0F;
        seen.at(x, y, channel) = (is_turned ? -value : value) * scale;
      }
    }
  }
  return seen;
}

RayRecord recordIn(const ViewChange& view, const RayRecord& record) {
  RayRecord seen{sizeIn(view, record.size), {}};
  const Crop crop = view.is_cropped ? cropOf(record.size) : Crop{0, 0, record.size};
  for (int y = 0; y < seen.size.height; ++y) {
    for (int x = 0; x < seen.size.width; ++x) {
      const Source from = sourceOf(view, record.size, x, y);
      RayHit ray = scaled(cropped(record.at(from.x, from.y), crop), view.scale);
      seen.rays.push_back(view.is_mirrored ? mirrored(ray, crop.size.width) : ray);
    }
  }
  return seen;
}

}  // namespace ssrkit
