#include "scene/gltf_schema.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "scene/clean_name.h"

namespace ssrkit {

namespace {

using nlohmann::json;

enum class Kind { kObject, kArray, kString, kBool, kNumber, kWhole, kIndex, kNumbers };

struct Rule {
  std::string_view path;  // '*': every element of an array or member of an object
  Kind kind = Kind::kObject;
  bool required = false;      // of its parent, where that is present
  std::string_view target{};  // kIndex: the array it points into
  std::size_t count = 0;      // kNumbers: how many
};

constexpr std::size_t kMaxElements = 262'144;  // of an array of objects

// Parents come before what they hold.
constexpr auto kRules = std::to_array<Rule>({
    {"extensionsUsed", Kind::kArray},
    {"extensionsUsed/*", Kind::kString},
    {"buffers", Kind::kArray},
    {"buffers/*", Kind::kObject},
    {"buffers/*/byteLength", Kind::kWhole, true},
    {"buffers/*/uri", Kind::kString},
    {"bufferViews", Kind::kArray},
    {"bufferViews/*", Kind::kObject},
    {"bufferViews/*/buffer", Kind::kIndex, true, "buffers"},
    {"bufferViews/*/byteOffset", Kind::kWhole},
    {"bufferViews/*/byteLength", Kind::kWhole, true},
    {"bufferViews/*/byteStride", Kind::kWhole},
    {"accessors", Kind::kArray},
    {"accessors/*", Kind::kObject},
    {"accessors/*/bufferView", Kind::kIndex, false, "bufferViews"},
    {"accessors/*/byteOffset", Kind::kWhole},
    {"accessors/*/componentType", Kind::kWhole, true},
    {"accessors/*/count", Kind::kWhole, true},
    {"accessors/*/type", Kind::kString, true},
    {"accessors/*/normalized", Kind::kBool},
    {"accessors/*/sparse", Kind::kObject},
    {"accessors/*/sparse/count", Kind::kWhole, true},
    {"accessors/*/sparse/indices", Kind::kObject, true},
    {"accessors/*/sparse/indices/bufferView", Kind::kIndex, true, "bufferViews"},
    {"accessors/*/sparse/indices/byteOffset", Kind::kWhole},
    {"accessors/*/sparse/indices/componentType", Kind::kWhole, true},
    {"accessors/*/sparse/values", Kind::kObject, true},
    {"accessors/*/sparse/values/bufferView", Kind::kIndex, true, "bufferViews"},
    {"accessors/*/sparse/values/byteOffset", Kind::kWhole},
    {"images", Kind::kArray},
    {"images/*", Kind::kObject},
    {"images/*/uri", Kind::kString},
    {"images/*/bufferView", Kind::kIndex, false, "bufferViews"},
    {"samplers", Kind::kArray},
    {"samplers/*", Kind::kObject},
    {"samplers/*/wrapS", Kind::kWhole},
    {"samplers/*/wrapT", Kind::kWhole},
    {"textures", Kind::kArray},
    {"textures/*", Kind::kObject},
    {"textures/*/source", Kind::kIndex, false, "images"},
    {"textures/*/sampler", Kind::kIndex, false, "samplers"},
    {"materials", Kind::kArray},
    {"materials/*", Kind::kObject},
    {"materials/*/name", Kind::kString},
    {"materials/*/extensions", Kind::kObject},
    {"materials/*/extensions/*", Kind::kObject},
    {"materials/*/extensions/KHR_materials_emissive_strength/emissiveStrength", Kind::kNumber},
    {"materials/*/extras/ssrkit_mirror", Kind::kBool},
    {"materials/*/emissiveFactor", Kind::kNumbers, false, {}, 3},
    {"materials/*/alphaMode", Kind::kString},
    {"materials/*/alphaCutoff", Kind::kNumber},
    {"materials/*/doubleSided", Kind::kBool},
    {"materials/*/pbrMetallicRoughness", Kind::kObject},
    {"materials/*/pbrMetallicRoughness/baseColorFactor", Kind::kNumbers, false, {}, 4},
    {"materials/*/pbrMetallicRoughness/metallicFactor", Kind::kNumber},
    {"materials/*/pbrMetallicRoughness/roughnessFactor", Kind::kNumber},
    {"materials/*/pbrMetallicRoughness/baseColorTexture", Kind::kObject},
    {"materials/*/pbrMetallicRoughness/baseColorTexture/index", Kind::kIndex, true, "textures"},
    {"materials/*/pbrMetallicRoughness/baseColorTexture/texCoord", Kind::kWhole},
    {"materials/*/pbrMetallicRoughness/baseColorTexture/extensions", Kind::kObject},
    {"materials/*/pbrMetallicRoughness/baseColorTexture/extensions/*", Kind::kObject},
    {"materials/*/pbrMetallicRoughness/metallicRoughnessTexture", Kind::kObject},
    {"materials/*/pbrMetallicRoughness/metallicRoughnessTexture/index", Kind::kIndex, true, "textures"},
    {"materials/*/pbrMetallicRoughness/metallicRoughnessTexture/texCoord", Kind::kWhole},
    {"materials/*/pbrMetallicRoughness/metallicRoughnessTexture/extensions", Kind::kObject},
    {"materials/*/pbrMetallicRoughness/metallicRoughnessTexture/extensions/*", Kind::kObject},
    {"materials/*/normalTexture", Kind::kObject},
    {"materials/*/normalTexture/index", Kind::kIndex, true, "textures"},
    {"materials/*/normalTexture/texCoord", Kind::kWhole},
    {"materials/*/normalTexture/scale", Kind::kNumber},
    {"materials/*/normalTexture/extensions", Kind::kObject},
    {"materials/*/normalTexture/extensions/*", Kind::kObject},
    {"materials/*/emissiveTexture", Kind::kObject},
    {"materials/*/emissiveTexture/index", Kind::kIndex, true, "textures"},
    {"materials/*/emissiveTexture/texCoord", Kind::kWhole},
    {"materials/*/emissiveTexture/extensions", Kind::kObject},
    {"materials/*/emissiveTexture/extensions/*", Kind::kObject},
    {"meshes", Kind::kArray},
    {"meshes/*", Kind::kObject},
    {"meshes/*/primitives", Kind::kArray, true},
    {"meshes/*/primitives/*", Kind::kObject},
    {"meshes/*/primitives/*/attributes", Kind::kObject, true},
    {"meshes/*/primitives/*/attributes/*", Kind::kIndex, false, "accessors"},
    {"meshes/*/primitives/*/indices", Kind::kIndex, false, "accessors"},
    {"meshes/*/primitives/*/material", Kind::kIndex, false, "materials"},
    {"meshes/*/primitives/*/mode", Kind::kWhole},
    {"cameras", Kind::kArray},
    {"cameras/*", Kind::kObject},
    {"cameras/*/name", Kind::kString},
    {"cameras/*/type", Kind::kString, true},
    {"cameras/*/perspective", Kind::kObject},
    {"cameras/*/perspective/yfov", Kind::kNumber, true},
    {"cameras/*/perspective/znear", Kind::kNumber, true},
    {"cameras/*/perspective/zfar", Kind::kNumber},
    {"cameras/*/perspective/aspectRatio", Kind::kNumber},
    {"extensions", Kind::kObject},
    {"extensions/KHR_lights_punctual", Kind::kObject},
    {"extensions/KHR_lights_punctual/lights", Kind::kArray, true},
    {"extensions/KHR_lights_punctual/lights/*", Kind::kObject},
    {"extensions/KHR_lights_punctual/lights/*/type", Kind::kString, true},
    {"extensions/KHR_lights_punctual/lights/*/color", Kind::kNumbers, false, {}, 3},
    {"extensions/KHR_lights_punctual/lights/*/intensity", Kind::kNumber},
    {"extensions/KHR_lights_punctual/lights/*/range", Kind::kNumber},
    {"extensions/KHR_lights_punctual/lights/*/spot", Kind::kObject},
    {"extensions/KHR_lights_punctual/lights/*/spot/innerConeAngle", Kind::kNumber},
    {"extensions/KHR_lights_punctual/lights/*/spot/outerConeAngle", Kind::kNumber},
    {"nodes", Kind::kArray},
    {"nodes/*", Kind::kObject},
    {"nodes/*/name", Kind::kString},
    {"nodes/*/children", Kind::kArray},
    {"nodes/*/children/*", Kind::kIndex, false, "nodes"},
    {"nodes/*/mesh", Kind::kIndex, false, "meshes"},
    {"nodes/*/camera", Kind::kIndex, false, "cameras"},
    {"nodes/*/skin", Kind::kIndex, false, "skins"},
    {"nodes/*/matrix", Kind::kNumbers, false, {}, 16},
    {"nodes/*/translation", Kind::kNumbers, false, {}, 3},
    {"nodes/*/rotation", Kind::kNumbers, false, {}, 4},
    {"nodes/*/scale", Kind::kNumbers, false, {}, 3},
    {"nodes/*/extensions", Kind::kObject},
    {"nodes/*/extensions/KHR_lights_punctual", Kind::kObject},
    {"nodes/*/extensions/KHR_lights_punctual/light", Kind::kIndex, true,
     "extensions/KHR_lights_punctual/lights"},
    {"scenes", Kind::kArray},
    {"scenes/*", Kind::kObject},
    {"scenes/*/nodes", Kind::kArray},
    {"scenes/*/nodes/*", Kind::kIndex, false, "nodes"},
    {"scene", Kind::kIndex, false, "scenes"},
});

constexpr auto kSupportedExtensions =
    std::to_array<std::string_view>({"KHR_lights_punctual", "KHR_materials_emissive_strength",
                                     "KHR_mesh_quantization", "KHR_texture_transform"});

// Length of the array at `path`, 0 where there is none.
std::size_t lengthOf(const json& root, std::string_view path) {
  const json* value = &root;
  while (!path.empty()) {
    const std::size_t slash = std::min(path.find('/'), path.size());
    const auto found = value->is_object() ? value->find(std::string(path.substr(0, slash))) : value->end();
    if (found == value->end()) {
      return 0;
    }
    value = &*found;
    path.remove_prefix(std::min(slash + 1, path.size()));
  }
  return value->is_array() ? value->size() : 0;
}

// What is wrong with the value by the rule, empty when nothing is.
std::string complaint(const Rule& rule, const json& value, std::size_t target_length) {
  const bool whole =
      value.is_number_unsigned() &&
      value.get<std::uint64_t>() <= static_cast<std::uint64_t>(std::numeric_limits<int>::max());
  switch (rule.kind) {
    case Kind::kObject:
      return value.is_object() ? "" : "is not an object";
    case Kind::kArray:
      if (value.is_array() && value.size() > kMaxElements) {
        return fmt::format("has {} elements and the limit is {}", value.size(), kMaxElements);
      }
      return value.is_array() ? "" : "is not an array";
    case Kind::kString:
      return value.is_string() ? "" : "is not a string";
    case Kind::kBool:
      return value.is_boolean() ? "" : "is neither true nor false";
    case Kind::kNumber:
      return value.is_number() ? "" : "is not a number";
    case Kind::kWhole:
      return whole ? "" : "is not a whole number between 0 and 2147483647";
    case Kind::kIndex:
      if (whole && value.get<std::size_t>() >= target_length) {
        return fmt::format("is {} and there are {} {}", value.get<std::size_t>(), target_length, rule.target);
      }
      return whole ? "" : "is not an index";
    case Kind::kNumbers:
      return value.is_array() && value.size() == rule.count &&
                     std::all_of(value.begin(), value.end(),
                                 [](const json& item) { return item.is_number(); })
                 ? ""
                 : fmt::format("is not an array of {} numbers", rule.count);
  }
  return "";
}

// Applies one rule to everything its path leads to. `rest` is what is left of the path below `value`.
class RuleWalk {
 public:
  RuleWalk(const GltfSource& source, const Rule& rule, std::size_t target_length)
      : source_(source), rule_(rule), target_length_(target_length) {}

  // NOLINTNEXTLINE(misc-no-recursion): as deep as the rule's path
  [[nodiscard]] Expected<void> visit(const json& value, std::string_view rest,
                                     const std::string& place) const {
    if (rest.empty()) {
      const std::string problem = complaint(rule_, value, target_length_);
      return problem.empty() ? Expected<void>{}
                             : Expected<void>(source_.refuse(place, "the value " + problem));
    }
    const std::size_t slash = std::min(rest.find('/'), rest.size());
    const std::string_view step = rest.substr(0, slash);
    rest.remove_prefix(std::min(slash + 1, rest.size()));
    if (step == "*") {
      return visitAll(value, rest, place);
    }
    const auto found = value.is_object() ? value.find(std::string(step)) : value.end();
    if (found != value.end()) {
      return visit(*found, rest, place.empty() ? std::string(step) : fmt::format("{}.{}", place, step));
    }
    if (rest.empty() && rule_.required) {
      return source_.refuse(place, fmt::format("'{}' is missing", step));
    }
    return {};
  }

 private:
  // NOLINTNEXTLINE(misc-no-recursion)
  [[nodiscard]] Expected<void> visitAll(const json& value, std::string_view rest,
                                        const std::string& place) const {
    std::size_t index = 0;
    for (auto item = value.begin(); item != value.end(); ++item, ++index) {
      const std::string item_place = value.is_object() ? fmt::format("{}.{}", place, cleanName(item.key()))
                                                       : fmt::format("{}[{}]", place, index);
      if (auto visited = visit(*item, rest, item_place); !visited) {
        return visited;
      }
    }
    return {};
  }

  const GltfSource& source_;
  const Rule& rule_;
  std::size_t target_length_;
};

Expected<void> checkVersion(const GltfSource& source, const json& root) {
  const auto asset = root.find("asset");
  if (asset == root.end() || !asset->is_object() || !asset->contains("version") ||
      !(*asset)["version"].is_string()) {
    return source.refuse("asset", "'version' is missing", "the file is not glTF 2.0");
  }
  const std::string version = (*asset)["version"].get<std::string>();
  if (version != "2" && !version.starts_with("2.")) {
    return source.refuse("asset.version", fmt::format("it is glTF '{}'", cleanName(version)),
                         "ssrkit reads glTF 2.0; convert the file with its exporter");
  }
  return {};
}

Expected<void> checkExtensions(const GltfSource& source, const json& root) {
  const auto required = root.find("extensionsRequired");
  if (required == root.end()) {
    return {};
  }
  if (!required->is_array()) {
    return source.refuse("extensionsRequired", "the value is not an array");
  }
  for (std::size_t i = 0; i < required->size(); ++i) {
    const std::string place = fmt::format("extensionsRequired[{}]", i);
    if (!(*required)[i].is_string()) {
      return source.refuse(place, "the value is not a string");
    }
    const std::string name = (*required)[i].get<std::string>();
    if (std::find(kSupportedExtensions.begin(), kSupportedExtensions.end(), name) ==
        kSupportedExtensions.end()) {
      return source.refuse(place,
                           fmt::format("the file needs {}, which ssrkit does not read", cleanName(name)),
                           "export it again without that extension");
    }
  }
  return {};
}

}  // namespace

Expected<void> checkGltfSchema(const GltfSource& source, const json& root) {
  if (auto version = checkVersion(source, root); !version) {
    return version;
  }
  if (auto extensions = checkExtensions(source, root); !extensions) {
    return extensions;
  }
  for (const Rule& rule : kRules) {
    const RuleWalk walk(source, rule, rule.target.empty() ? 0 : lengthOf(root, rule.target));
    if (auto visited = walk.visit(root, rule.path, ""); !visited) {
      return visited;
    }
  }
  return {};
}

}  // namespace ssrkit
