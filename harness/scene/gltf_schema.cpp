#include "scene/gltf_schema.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "scene/clean_name.h"
#include "scene/gltf_rules.h"

namespace ssrkit {

namespace {

using nlohmann::json;

constexpr std::size_t kMaxElements = 262'144;  // of an array of objects

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
std::string complaint(const GltfRule& rule, const json& value, std::size_t target_length) {
  const bool whole =
      value.is_number_unsigned() &&
      value.get<std::uint64_t>() <= static_cast<std::uint64_t>(std::numeric_limits<int>::max());
  switch (rule.kind) {
    case GltfKind::kObject:
      return value.is_object() ? "" : "is not an object";
    case GltfKind::kArray:
      if (value.is_array() && value.size() > kMaxElements) {
        return fmt::format("has {} elements and the limit is {}", value.size(), kMaxElements);
      }
      return value.is_array() ? "" : "is not an array";
    case GltfKind::kString:
      return value.is_string() ? "" : "is not a string";
    case GltfKind::kBool:
      return value.is_boolean() ? "" : "is neither true nor false";
    case GltfKind::kNumber:
      return value.is_number() ? "" : "is not a number";
    case GltfKind::kWhole:
      return whole ? "" : "is not a whole number between 0 and 2147483647";
    case GltfKind::kIndex:
      if (whole && value.get<std::size_t>() >= target_length) {
        return fmt::format("is {} and there are {} {}", value.get<std::size_t>(), target_length, rule.target);
      }
      return whole ? "" : "is not an index";
    case GltfKind::kNumbers:
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
  RuleWalk(const GltfSource& source, const GltfRule& rule, std::size_t target_length)
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
  const GltfRule& rule_;
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
    if (!isReadExtension(name)) {
      return source.refuse(place,
                           fmt::format("the file needs {}, which ssrkit does not read", cleanName(name)),
                           "export it again without that extension");
    }
  }
  return {};
}

}  // namespace

bool isReadExtension(std::string_view name) {
  constexpr auto kRead =
      std::to_array<std::string_view>({"KHR_lights_punctual", "KHR_materials_emissive_strength",
                                       "KHR_mesh_quantization", "KHR_texture_transform"});
  return std::find(kRead.begin(), kRead.end(), name) != kRead.end();
}

Expected<void> checkGltfSchema(const GltfSource& source, const json& root) {
  if (auto version = checkVersion(source, root); !version) {
    return version;
  }
  if (auto extensions = checkExtensions(source, root); !extensions) {
    return extensions;
  }
  for (const GltfRule& rule : kGltfRules) {
    const RuleWalk walk(source, rule, rule.target.empty() ? 0 : lengthOf(root, rule.target));
    if (auto visited = walk.visit(root, rule.path, ""); !visited) {
      return visited;
    }
  }
  return {};
}

}  // namespace ssrkit
