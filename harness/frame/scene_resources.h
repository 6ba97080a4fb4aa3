// A scene on the device: vertices, material table, textures; and its lights as uniforms.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/error.h"
#include "device/device.h"
#include "frame/uniform_values.h"
#include "scene/scene.h"

namespace ssrkit {

struct SceneResources {
  std::unique_ptr<DeviceBuffer> vertices;
  std::unique_ptr<DeviceImage> material_table;  // one row a material, layout in shaders/gbuffer.frag
  std::vector<std::unique_ptr<DeviceImage>> srgb_textures;  // by texture index, null where nobody uses it so
  std::vector<std::unique_ptr<DeviceImage>> linear_textures;
  std::unique_ptr<DeviceImage> white;  // stands for every texture that a material lacks
};

[[nodiscard]] Expected<SceneResources> uploadScene(Device& device, const Scene& scene);

// The vertices as they are posed now.
[[nodiscard]] Expected<std::unique_ptr<DeviceBuffer>> uploadVertices(Device& device, const Scene& scene);

// How gbuffer.vert reads scene.h's Vertex.
[[nodiscard]] std::vector<VertexAttribute> vertexAttributes();

// The image for one of gbuffer.frag's texture samplers ("base_colour_texture", ...) in one range's material.
[[nodiscard]] SampledImage materialTexture(const SceneResources& resources, const Scene& scene,
                                           int material_index, const std::string& sampler);

// What a scene has, as constants that programs are specialised by: how many lights of each kind, which never
// changes while it moves ...
[[nodiscard]] std::map<std::string, UniformConstant> lightConstants(const Scene& scene);

// ... and which of gbuffer.frag's texture samplers any of its materials uses: has_base_colour_texture, ...
[[nodiscard]] std::map<std::string, UniformConstant> textureConstants(const Scene& scene);

// Lights and sky in view space, under the names of shaders/light.frag.
void setLightUniforms(UniformValues& values, const Scene& scene, const glm::dmat4& view_from_world);

}  // namespace ssrkit
