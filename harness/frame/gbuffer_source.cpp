#include "frame/gbuffer_source.h"

#include "frame/image_transfer.h"

namespace ssrkit {

namespace {

std::vector<Format> gbufferFormats() {
  std::vector<Format> formats;
  for (const FrameImageRow& row : gbufferImages()) {
    formats.push_back(row.format);
  }
  return formats;
}

// The samplers whose image changes from material to material.
std::vector<SampledImage> rangeTextures(const Program& program, const Scene& scene,
                                        const SceneResources& resources, int material_index) {
  std::vector<SampledImage> sampled;
  for (const SamplerBinding& sampler : program.samplers) {
    if (sampler.name != "material_table") {
      sampled.push_back(materialTexture(resources, scene, material_index, sampler.name));
      sampled.back().binding = sampler.binding;
    }
  }
  return sampled;
}

}  // namespace

const PassRow& gbufferPass() {
  static const PassRow row{.name = "gbuffer",
                           .vertex_shader = "gbuffer.vert",
                           .fragment_shader = "gbuffer.frag",
                           .colour_formats = gbufferFormats(),
                           .has_depth = true,
                           .vertex_attributes = vertexAttributes(),
                           .vertex_stride_bytes = sizeof(Vertex)};
  return row;
}

Expected<PassTime> drawGbuffer(Device& device, const Program& program, const Scene& scene,
                               const SceneResources& resources, FrameImages& images,
                               const UniformValues& values) {
  PassDesc pass{.name = "gbuffer",
                .program = program.device_program.get(),
                .sampled = {},
                .uniform_binding = 0,
                .uniforms = {},
                .vertices = resources.vertices.get(),
                .colour = {},
                .depth = std::nullopt,
                .viewport = {0, 0, images.size().width, images.size().height},
                .draws = {}};
  for (const FrameImageRow& row : gbufferImages()) {
    const auto image = images.get(row.name);
    if (!image) {
      return tl::make_unexpected(image.error());
    }
    pass.colour.push_back({*image, 0, row.clear});
  }
  const auto depth = images.get("depth_window");
  if (!depth) {
    return tl::make_unexpected(depth.error());
  }
  pass.depth = Attachment{*depth, 0, frameImageRow("depth_window").clear};
  std::vector<std::byte> uniforms;
  if (program.uniform_block) {
    auto packed = values.pack(*program.uniform_block, program.shader);
    if (!packed) {
      return tl::make_unexpected(packed.error());
    }
    uniforms = std::move(*packed);
    pass.uniform_binding = program.uniform_block->binding;
    pass.uniforms = uniforms;
  }
  for (const SamplerBinding& sampler : program.samplers) {
    if (sampler.name == "material_table") {
      pass.sampled.push_back({.binding = sampler.binding, .image = resources.material_table.get()});
    }
  }
  for (const DrawRange& range : scene.ranges) {
    pass.draws.push_back({.first_vertex = range.first_vertex,
                          .vertex_count = range.vertex_count,
                          .sampled = rangeTextures(program, scene, resources, range.material_index)});
  }
  return device.draw(pass);
}

Expected<void> uploadGbuffer(Device& device, const std::map<std::string, Image>& gbuffer,
                             FrameImages& images) {
  for (const FrameImageRow& row : gbufferImages()) {
    const auto image = images.get(row.name);
    if (!image) {
      return tl::make_unexpected(image.error());
    }
    const auto given = gbuffer.find(row.name);
    const auto done = given != gbuffer.end() ? uploadImage(device, **image, given->second, row.upload_default)
                                             : fillImage(device, **image, row.upload_default);
    if (!done) {
      return done;
    }
  }
  return {};
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
  values.set("clip_from_view", camera.clip_from_view);
  values.set("view_from_world", camera.view_from_world);
  // Set anew by buildPyramid; the tracers that read no pyramid share the block.
  values.set("atlas_rows", 0.0);
  values.set("atlas_texel_uv", glm::dvec2(0.0));
}

}  // namespace ssrkit
