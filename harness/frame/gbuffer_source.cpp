#include "frame/gbuffer_source.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

#include "base/check.h"
#include "base/size.h"
#include "frame/geometry_pass.h"
#include "frame/image_transfer.h"
#include "frame/pyramid.h"
#include "frame/stages.h"

namespace ssrkit {

namespace {

std::vector<Format> gbufferFormats() {
  std::vector<Format> formats;
  for (const FrameImageRow& row : gbufferImages()) {
    formats.push_back(row.format);
  }
  formats.push_back(frameImageRow("dist_range").format);
  return formats;
}

// The atlas of the depth pyramid as `hiz` reads it unless told otherwise, or where there is none of that size
// an image that nobody reads.
Expected<DeviceImage*> rangeImage(FrameImages& images) {
  const auto stage = findStage("hiz");
  SSRKIT_CHECK(stage.has_value());
  const Size atlas = atlasSize(images.size(), withStageDefaults({}, **stage, images.size()).max_mip);
  const bool fits = std::max(atlas.width, atlas.height) <= kMaxImageSide;
  return images.getSized({.name = "dist_range",
                          .format = frameImageRow("dist_range").format,
                          .size = fits ? atlas : images.size()});
}

// With what gbuffer.frag writes beside the given channels: alpha 1 on surfaces, 0 for background.
Image materialWithAlpha(const Image* given, const std::array<float, 4>& defaults, const Image& dist_view) {
  Image material(dist_view.size, {"R", "G", "B", "A"});
  for (int y = 0; y < material.size.height; ++y) {
    for (int x = 0; x < material.size.width; ++x) {
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const bool is_given = given != nullptr && channel < given->channelCount();
        material.at(x, y, channel) = is_given ? given->at(x, y, channel) : defaults[channel];
      }
      material.at(x, y, 3) = std::isinf(dist_view.at(x, y)) ? 0.0F : 1.0F;
    }
  }
  return material;
}

Expected<void> uploadDepthWindow(Device& device, const Image& dist_view, const Camera& camera,
                                 FrameImages& images) {
  const auto image = images.get("depth_window");
  if (!image) {
    return tl::make_unexpected(image.error());
  }
  Image depth(dist_view.size, {"Z"});
  for (int y = 0; y < depth.size.height; ++y) {
    for (int x = 0; x < depth.size.width; ++x) {
      const double stored = depthWindowFromDistView(camera, dist_view.at(x, y));
      depth.at(x, y) = static_cast<float>(std::clamp(stored, 0.0, 1.0));
    }
  }
  return uploadImage(device, **image, depth, {});
}

}  // namespace

const PassRow& gbufferPass() {
  static const PassRow row{.name = "gbuffer",
                           .vertex_shader = "gbuffer.vert",
                           .fragment_shader = "gbuffer.frag",
                           .colour_formats = gbufferFormats(),
                           .depth_test = DepthTest::kNearer,
                           .vertex_attributes = vertexAttributes(),
                           .vertex_stride_bytes = sizeof(Vertex)};
  return row;
}

PassRow gbufferPassFor(const CompileSettings& settings, const Scene& scene) {
  PassRow row = gbufferPass();
  row.constants = textureConstants(scene);
  if (settings.replacements.contains(row.name) || settings.replacements.contains(pyramidBasePass().name)) {
    row.colour_formats.pop_back();
  }
  return row;
}

Expected<PassTime> drawGbuffer(Device& device, const Program& program, const Scene& scene,
                               const SceneResources& resources, FrameImages& images,
                               const UniformValues& values) {
  GeometryPass pass{.row = &gbufferPass(),
                    .ranges = scene.ranges,
                    .colour = {},
                    .depth = {},
                    .viewport = {0, 0, images.size().width, images.size().height}};
  std::vector<std::string> names;
  std::ranges::transform(gbufferImages(), std::back_inserter(names), &FrameImageRow::name);
  if (program.target_count > names.size()) {
    names.emplace_back("dist_range");
  } else {
    images.drop("dist_range");  // an earlier frame's
  }
  for (const std::string& name : names) {
    const auto image = name == "dist_range" ? rangeImage(images) : images.get(name);
    if (!image) {
      return tl::make_unexpected(image.error());
    }
    pass.colour.push_back({*image, 0, frameImageRow(name).clear});
  }
  const auto depth = images.get("depth_window");
  if (!depth) {
    return tl::make_unexpected(depth.error());
  }
  pass.depth = {*depth, 0, frameImageRow("depth_window").clear};
  return drawGeometry(device, program, pass, scene, resources, values);
}

Expected<void> uploadGbuffer(Device& device, const std::map<std::string, Image>& gbuffer,
                             const Camera& camera, FrameImages& images) {
  const Image& dist_view = gbuffer.at("dist_view");
  images.drop("dist_range");  // an earlier scene's
  for (const FrameImageRow& row : gbufferImages()) {
    const auto image = images.get(row.name);
    if (!image) {
      return tl::make_unexpected(image.error());
    }
    const auto found = gbuffer.find(row.name);
    const Image* const given = found != gbuffer.end() ? &found->second : nullptr;
    const auto done =
        row.name == "material"
            ? uploadImage(device, **image, materialWithAlpha(given, row.upload_default, dist_view), {})
        : given != nullptr ? uploadImage(device, **image, *given, row.upload_default)
                           : fillImage(device, **image, row.upload_default);
    if (!done) {
      return done;
    }
  }
  return uploadDepthWindow(device, dist_view, camera, images);
}

void setCameraUniforms(UniformValues& values, const Camera& camera) {
  const PixelProjection projection = pixelProjection(camera);
  const glm::dvec2 size(camera.size.width, camera.size.height);
  values.set("size_px", size);
  values.set("texel_uv", 1.0 / size);
  values.set("px_scale", projection.px_scale);
  values.set("px_offset", projection.px_offset);
  values.set("view_per_px", 1.0 / projection.px_scale);
  values.set("near_m", camera.near_m);
  values.set("far_m", camera.far_m);
  values.set("clip_from_view", camera.clip_from_view);
  values.set("view_from_world", camera.view_from_world);
  values.set("world_from_view", glm::inverse(camera.view_from_world));
  const glm::dmat4 previous = camera.previous_view_from_world.value_or(camera.view_from_world);
  values.set("previous_view_from_world", previous);
  // Exactly the identity when the camera stands still, so that reprojection is.
  values.set("previous_view_from_view", camera.previous_view_from_world
                                            ? previous * glm::inverse(camera.view_from_world)
                                            : glm::dmat4(1.0));
  // Set anew by buildPyramid; the tracers that read no pyramid share the block.
  values.set("atlas_rows", 0.0);
  values.set("atlas_texel_uv", glm::dvec2(0.0));
}

}  // namespace ssrkit
