#include "frame/scene_resources.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace ssrkit {

namespace {

constexpr int kMaterialColumns = 3;

struct TextureSlot {
  std::string sampler;
  int Material::*texture;
  bool is_srgb;
};

const std::vector<TextureSlot>& slots() {
  static const std::vector<TextureSlot> table = {
      {"base_colour_texture", &Material::base_colour_texture, true},
      {"metallic_roughness_texture", &Material::metallic_roughness_texture, false},
      {"normal_texture", &Material::normal_texture, false},
      {"emissive_texture", &Material::emissive_texture, true},
  };
  return table;
}

AddressMode addressMode(Wrap wrap) {
  switch (wrap) {
    case Wrap::kRepeat:
      return AddressMode::kRepeat;
    case Wrap::kClamp:
      return AddressMode::kClamp;
    case Wrap::kMirror:
      return AddressMode::kMirror;
  }
  return AddressMode::kRepeat;
}

Expected<std::unique_ptr<DeviceImage>> uploadBytes(Device& device, const ImageDesc& desc,
                                                   std::span<const std::byte> bytes) {
  auto image = device.createImage(desc);
  if (!image) {
    return image;
  }
  if (const auto uploaded = device.upload(**image, 0, bytes); !uploaded) {
    return tl::make_unexpected(uploaded.error());
  }
  return image;
}

// The bits of shaders/include/material_flags.glsl.
float materialFlags(const Material& m) {
  const auto bit = [](bool is_set, int position) { return is_set ? 1 << position : 0; };
  return static_cast<float>(bit(m.mirror, 0) + bit(m.base_colour_texture >= 0, 1) +
                            bit(m.metallic_roughness_texture >= 0, 2) + bit(m.normal_texture >= 0, 3) +
                            bit(m.emissive_texture >= 0, 4) + bit(m.double_sided, 5));
}

std::vector<float> materialRows(const Scene& scene) {
  std::vector<float> rows;
  rows.reserve(scene.materials.size() * kMaterialColumns * 4);
  for (const Material& m : scene.materials) {
    const bool is_opaque = m.alpha_mode == AlphaMode::kOpaque;
    const float cutoff = is_opaque ? -1.0F : m.alpha_mode == AlphaMode::kBlend ? 0.5F : m.alpha_cutoff;
    rows.insert(rows.end(), {m.base_colour.r, m.base_colour.g, m.base_colour.b, m.base_colour.a});
    rows.insert(rows.end(), {m.metallic, m.roughness, materialFlags(m), cutoff});
    rows.insert(rows.end(), {m.emissive.r, m.emissive.g, m.emissive.b, m.normal_scale});
  }
  return rows;
}

Expected<void> uploadTextures(Device& device, const Scene& scene, SceneResources& resources) {
  resources.srgb_textures.resize(scene.textures.size());
  resources.linear_textures.resize(scene.textures.size());
  for (const Material& material : scene.materials) {
    for (const TextureSlot& slot : slots()) {
      const int index = material.*slot.texture;
      if (index < 0) {
        continue;
      }
      auto& list = slot.is_srgb ? resources.srgb_textures : resources.linear_textures;
      auto& image = list[static_cast<std::size_t>(index)];
      if (image != nullptr) {
        continue;
      }
      const Texture& texture = scene.textures[static_cast<std::size_t>(index)];
      auto uploaded = uploadBytes(device,
                                  {.name = texture.name,
                                   .format = slot.is_srgb ? Format::kRgba8Srgb : Format::kRgba8,
                                   .size = texture.size,
                                   .mip_count = 1},
                                  std::as_bytes(std::span(texture.rgba)));
      if (!uploaded) {
        return tl::make_unexpected(uploaded.error());
      }
      image = std::move(*uploaded);
    }
  }
  return {};
}

}  // namespace

std::vector<VertexAttribute> vertexAttributes() {
  return {{0, VertexFormat::kFloat3, offsetof(Vertex, p_world)},
          {1, VertexFormat::kFloat3, offsetof(Vertex, normal_world)},
          {2, VertexFormat::kFloat4, offsetof(Vertex, tangent_world)},
          {3, VertexFormat::kFloat2, offsetof(Vertex, uv)},
          {4, VertexFormat::kFloat3, offsetof(Vertex, face_normal_world)},
          {5, VertexFormat::kFloat1, offsetof(Vertex, material_index)},
          {6, VertexFormat::kFloat3, offsetof(Vertex, p_previous_world)}};
}

Expected<std::unique_ptr<DeviceBuffer>> uploadVertices(Device& device, const Scene& scene) {
  return device.createVertexBuffer(std::as_bytes(std::span(scene.vertices)));
}

Expected<SceneResources> uploadScene(Device& device, const Scene& scene) {
  SceneResources resources;
  auto vertices = uploadVertices(device, scene);
  if (!vertices) {
    return tl::make_unexpected(vertices.error());
  }
  resources.vertices = std::move(*vertices);
  const std::vector<float> rows = materialRows(scene);
  auto table = uploadBytes(device,
                           {.name = "material_table",
                            .format = Format::kRgba32f,
                            .size = {kMaterialColumns, static_cast<int>(scene.materials.size())},
                            .mip_count = 1},
                           std::as_bytes(std::span(rows)));
  if (!table) {
    return tl::make_unexpected(table.error());
  }
  resources.material_table = std::move(*table);
  constexpr std::array<std::uint8_t, 4> kWhite{255, 255, 255, 255};
  auto white =
      uploadBytes(device, {.name = "white", .format = Format::kRgba8, .size = {1, 1}, .mip_count = 1},
                  std::as_bytes(std::span(kWhite)));
  if (!white) {
    return tl::make_unexpected(white.error());
  }
  resources.white = std::move(*white);
  if (const auto uploaded = uploadTextures(device, scene, resources); !uploaded) {
    return tl::make_unexpected(uploaded.error());
  }
  return resources;
}

SampledImage materialTexture(const SceneResources& resources, const Scene& scene, int material_index,
                             const std::string& sampler) {
  const auto slot = std::ranges::find(slots(), sampler, &TextureSlot::sampler);
  SampledImage sampled{.image = resources.white.get(), .filter = Filter::kLinear};
  if (slot == slots().end()) {
    return sampled;
  }
  const int index = scene.materials[static_cast<std::size_t>(material_index)].*slot->texture;
  if (index >= 0) {
    const auto at = static_cast<std::size_t>(index);
    sampled.image = (slot->is_srgb ? resources.srgb_textures : resources.linear_textures)[at].get();
    sampled.address_u = addressMode(scene.textures[at].wrap_u);
    sampled.address_v = addressMode(scene.textures[at].wrap_v);
  }
  return sampled;
}

std::map<std::string, UniformConstant> lightConstants(const Scene& scene) {
  return {
      {"directional_count", static_cast<int>(std::min(scene.directional_lights.size(), kMaxLightsOfAKind))},
      {"point_count", static_cast<int>(std::min(scene.point_lights.size(), kMaxLightsOfAKind))}};
}

std::map<std::string, UniformConstant> textureConstants(const Scene& scene) {
  std::map<std::string, UniformConstant> constants;
  for (const TextureSlot& slot : slots()) {
    const bool has_any = std::ranges::any_of(
        scene.materials, [&](const Material& material) { return material.*slot.texture >= 0; });
    constants.emplace("has_" + slot.sampler, has_any ? 1 : 0);
  }
  return constants;
}

void setLightUniforms(UniformValues& values, const Scene& scene, const glm::dmat4& view_from_world) {
  const glm::dmat3 rotation(view_from_world);
  values.set("up_view", rotation * glm::dvec3(0, 1, 0));
  values.set("sky_horizon", glm::dvec3(scene.sky_horizon));
  values.set("sky_zenith", glm::dvec3(scene.sky_zenith));
  std::vector<glm::dvec4> directions(kMaxLightsOfAKind);
  std::vector<glm::dvec4> radiances(kMaxLightsOfAKind);
  const std::size_t directional_count = std::min(scene.directional_lights.size(), kMaxLightsOfAKind);
  for (std::size_t i = 0; i < directional_count; ++i) {
    const DirectionalLight& light = scene.directional_lights[i];
    directions[i] = glm::dvec4(rotation * light.direction_world, 0);
    radiances[i] = glm::dvec4(glm::dvec3(light.radiance), 0);
  }
  values.set("directional_count", static_cast<int>(directional_count));
  values.set("directional_dir_view", directions);
  values.set("directional_radiance", radiances);
  std::vector<glm::dvec4> positions(kMaxLightsOfAKind);
  std::vector<glm::dvec4> axes(kMaxLightsOfAKind);
  std::vector<glm::dvec4> intensities(kMaxLightsOfAKind);
  const std::size_t point_count = std::min(scene.point_lights.size(), kMaxLightsOfAKind);
  for (std::size_t i = 0; i < point_count; ++i) {
    const PointLight& light = scene.point_lights[i];
    positions[i] = glm::dvec4(glm::dvec3(view_from_world * glm::dvec4(light.p_world, 1)), light.range_m);
    axes[i] = glm::dvec4(rotation * light.direction_world, light.outer_cone_cos);
    intensities[i] = glm::dvec4(glm::dvec3(light.intensity), light.inner_cone_cos);
  }
  values.set("point_count", static_cast<int>(point_count));
  values.set("point_p_view", positions);
  values.set("point_dir_view", axes);
  values.set("point_intensity", intensities);
}

}  // namespace ssrkit
