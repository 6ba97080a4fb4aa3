#include "scene/gltf_materials.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "scene/clean_name.h"
#include "scene/gltf_images.h"

namespace ssrkit {

namespace {

constexpr std::size_t kMaxTextureBytes = std::size_t{1} << 30;  // of all textures, decoded

float fraction(double value) {
  return static_cast<float>(std::clamp(value, 0.0, 1.0));
}

Wrap wrapOf(int gl_name) {
  switch (gl_name) {
    case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
      return Wrap::kClamp;
    case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
      return Wrap::kMirror;
    default:
      return Wrap::kRepeat;
  }
}

std::optional<double> numberIn(const tinygltf::Value& object, const std::string& name) {
  if (!object.IsObject() || !object.Has(name) || !object.Get(name).IsNumber()) {
    return std::nullopt;
  }
  return object.Get(name).GetNumberAsDouble();
}

glm::vec2 pairIn(const tinygltf::Value& object, const std::string& name, const glm::vec2& otherwise) {
  if (!object.IsObject() || !object.Has(name)) {
    return otherwise;
  }
  const tinygltf::Value& pair = object.Get(name);
  if (!pair.IsArray() || pair.ArrayLen() != 2 || !pair.Get(0).IsNumber() || !pair.Get(1).IsNumber()) {
    return otherwise;
  }
  return {pair.Get(0).GetNumberAsDouble(), pair.Get(1).GetNumberAsDouble()};
}

template <class Info>
UvSource uvSourceOf(const Info& info) {
  UvSource source;
  source.set = info.texCoord;
  const auto extension = info.extensions.find("KHR_texture_transform");
  if (extension == info.extensions.end()) {
    return source;
  }
  const tinygltf::Value& transform = extension->second;
  const glm::vec2 offset = pairIn(transform, "offset", glm::vec2(0.0F));
  const glm::vec2 scale = pairIn(transform, "scale", glm::vec2(1.0F));
  const double angle = numberIn(transform, "rotation").value_or(0.0);
  const auto cosine = static_cast<float>(std::cos(angle));
  const auto sine = static_cast<float>(std::sin(angle));
  // The extension's T * R * S, column by column.
  source.uv_from_file = glm::mat3(cosine * scale.x, -sine * scale.x, 0.0F,  //
                                  sine * scale.y, cosine * scale.y, 0.0F,   //
                                  offset.x, offset.y, 1.0F);
  source.set = static_cast<int>(numberIn(transform, "texCoord").value_or(source.set));
  return source;
}

class MaterialReader {
 public:
  explicit MaterialReader(GltfDocument& document) : document_(document) {}

  [[nodiscard]] Expected<GltfMaterials> read() {
    for (const tinygltf::Material& material : document_.model->materials) {
      if (auto added = add(material); !added) {
        return tl::make_unexpected(added.error());
      }
    }
    Material unnamed;
    unnamed.name = "default";
    result_.materials.push_back(unnamed);
    result_.uv_sources.emplace_back();
    document_.tally.mixed_uv_materials = mixed_uvs_;
    document_.tally.unread_textures = without_image_;
    return std::move(result_);
  }

 private:
  Expected<void> add(const tinygltf::Material& from) {
    const auto& pbr = from.pbrMetallicRoughness;
    Material material = factorsOf(from);
    std::optional<UvSource> uv;
    const Expected<void> loaded =
        addTexture(pbr.baseColorTexture, material.base_colour_texture, uv)
            .and_then([&] {
              return addTexture(pbr.metallicRoughnessTexture, material.metallic_roughness_texture, uv);
            })
            .and_then([&] { return addTexture(from.normalTexture, material.normal_texture, uv); })
            .and_then([&] { return addTexture(from.emissiveTexture, material.emissive_texture, uv); });
    if (!loaded) {
      return loaded;
    }
    result_.materials.push_back(std::move(material));
    result_.uv_sources.push_back(uv.value_or(UvSource{}));
    return {};
  }

  [[nodiscard]] Material factorsOf(const tinygltf::Material& from) const {
    const auto& pbr = from.pbrMetallicRoughness;
    Material material;
    material.name = cleanName(from.name);
    if (material.name.empty()) {
      material.name = fmt::format("material {}", result_.materials.size());
    }
    for (int i = 0; i < 4 && pbr.baseColorFactor.size() == 4; ++i) {
      material.base_colour[i] = fraction(pbr.baseColorFactor[static_cast<std::size_t>(i)]);
    }
    material.metallic = fraction(pbr.metallicFactor);
    material.roughness = fraction(pbr.roughnessFactor);
    const auto strength = from.extensions.find("KHR_materials_emissive_strength");
    const double scale = strength == from.extensions.end()
                             ? 1.0
                             : numberIn(strength->second, "emissiveStrength").value_or(1.0);
    for (int i = 0; i < 3 && from.emissiveFactor.size() == 3; ++i) {
      constexpr double kMaxEmissive = 1e6;
      material.emissive[i] = static_cast<float>(
          std::clamp(from.emissiveFactor[static_cast<std::size_t>(i)] * scale, 0.0, kMaxEmissive));
    }
    material.normal_scale = static_cast<float>(std::clamp(from.normalTexture.scale, -100.0, 100.0));
    material.alpha_cutoff = fraction(from.alphaCutoff);
    material.alpha_mode = from.alphaMode == "MASK"    ? AlphaMode::kMask
                          : from.alphaMode == "BLEND" ? AlphaMode::kBlend
                                                      : AlphaMode::kOpaque;
    material.double_sided = from.doubleSided;
    const bool has_extra = from.extras.IsObject() && from.extras.Has("ssrkit_mirror") &&
                           from.extras.Get("ssrkit_mirror").IsBool();
    material.mirror = has_extra ? from.extras.Get("ssrkit_mirror").Get<bool>()
                                : material.metallic >= 0.5F && material.roughness <= 0.3F;
    return material;
  }

  // Loads the texture of `info`, if it has one, and notes where its coordinates come from.
  template <class Info>
  Expected<void> addTexture(const Info& info, int& texture_index, std::optional<UvSource>& uv) {
    if (info.index < 0) {
      return {};
    }
    const tinygltf::Texture& texture = document_.model->textures[static_cast<std::size_t>(info.index)];
    if (texture.source < 0) {
      ++without_image_;
      return {};
    }
    const UvSource source = uvSourceOf(info);
    mixed_uvs_ += uv && (uv->set != source.set || uv->uv_from_file != source.uv_from_file) ? 1U : 0U;
    uv = uv.value_or(source);
    Expected<int> loaded = load(texture);
    if (!loaded) {
      return tl::make_unexpected(loaded.error());
    }
    texture_index = *loaded;
    return {};
  }

  // One texture for each pair of image and wrap modes.
  Expected<int> load(const tinygltf::Texture& from) {
    const auto* sampler =
        from.sampler < 0 ? nullptr : &document_.model->samplers[static_cast<std::size_t>(from.sampler)];
    const std::array<int, 3> key{from.source, sampler == nullptr ? 0 : sampler->wrapS,
                                 sampler == nullptr ? 0 : sampler->wrapT};
    if (const auto known = indices_.find(key); known != indices_.end()) {
      return known->second;
    }
    Expected<Texture> texture = decodeGltfImage(document_, from.source);
    if (!texture) {
      return tl::make_unexpected(texture.error());
    }
    texture_bytes_ += texture->rgba.size();
    if (texture_bytes_ > kMaxTextureBytes) {
      return document_.source.refuse("images", "the textures take more than 1 GiB when decoded");
    }
    texture->name = fmt::format("image {}", from.source);
    texture->wrap_u = wrapOf(key[1]);
    texture->wrap_v = wrapOf(key[2]);
    result_.textures.push_back(*std::move(texture));
    return indices_[key] = static_cast<int>(result_.textures.size()) - 1;
  }

  GltfDocument& document_;
  GltfMaterials result_;
  std::map<std::array<int, 3>, int> indices_;
  std::size_t texture_bytes_ = 0;
  std::size_t mixed_uvs_ = 0;
  std::size_t without_image_ = 0;
};

}  // namespace

Expected<GltfMaterials> readMaterials(GltfDocument& document) {
  return MaterialReader(document).read();
}

}  // namespace ssrkit
