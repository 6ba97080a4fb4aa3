#include "frame/geometry_pass.h"

namespace ssrkit {

namespace {

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

Expected<PassTime> drawGeometry(Device& device, const Program& program, const GeometryPass& pass,
                                const Scene& scene, const SceneResources& resources,
                                const UniformValues& values) {
  PassDesc desc{.name = pass.row->name,
                .program = program.device_program.get(),
                .sampled = {},
                .uniform_binding = 0,
                .uniforms = {},
                .vertices = resources.vertices.get(),
                .colour = pass.colour,
                .depth = pass.depth,
                .viewport = pass.viewport,
                .draws = {}};
  std::vector<std::byte> uniforms;
  if (program.uniform_block) {
    auto packed = values.pack(*program.uniform_block, program.shader);
    if (!packed) {
      return tl::make_unexpected(packed.error());
    }
    uniforms = std::move(*packed);
    desc.uniform_binding = program.uniform_block->binding;
    desc.uniforms = uniforms;
  }
  for (const SamplerBinding& sampler : program.samplers) {
    if (sampler.name == "material_table") {
      desc.sampled.push_back({.binding = sampler.binding, .image = resources.material_table.get()});
    }
  }
  for (const DrawRange& range : pass.ranges) {
    desc.draws.push_back({.first_vertex = range.first_vertex,
                          .vertex_count = range.vertex_count,
                          .sampled = rangeTextures(program, scene, resources, range.material_index)});
  }
  return device.draw(desc);
}

}  // namespace ssrkit
