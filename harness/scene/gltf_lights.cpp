#include "scene/gltf_lights.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/gtc/constants.hpp>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "base/text.h"
#include "scene/clean_name.h"
#include "scene/framing.h"

namespace ssrkit {

namespace {

// The light that the node carries, if any. The index was checked against the file's lights.
const tinygltf::Light* lightOf(const tinygltf::Model& model, const tinygltf::Node& node) {
  const auto extension = node.extensions.find("KHR_lights_punctual");
  if (extension == node.extensions.end() || !extension->second.IsObject() ||
      !extension->second.Has("light")) {
    return nullptr;
  }
  const auto index = static_cast<std::size_t>(extension->second.Get("light").GetNumberAsInt());
  return index < model.lights.size() ? &model.lights[index] : nullptr;
}

std::string nameOf(const tinygltf::Light& light, const tinygltf::Node& node, int node_index) {
  const std::string name = cleanName(light.name.empty() ? node.name : light.name);
  return name.empty() ? fmt::format("that of node {}", node_index) : name;
}

glm::vec3 intensityOf(const tinygltf::Light& light) {
  constexpr double kMaxIntensity = 1e12;
  glm::vec3 colour(1.0F);
  for (int i = 0; i < 3 && light.color.size() == 3; ++i) {
    colour[i] = static_cast<float>(std::clamp(light.color[static_cast<std::size_t>(i)], 0.0, 1.0));
  }
  return colour * static_cast<float>(std::clamp(light.intensity, 0.0, kMaxIntensity));
}

PointLight pointLightOf(const tinygltf::Light& from, const PlacedNode& placed) {
  PointLight light;
  light.p_world = glm::dvec3(placed.world_from_node[3]);
  light.direction_world = aheadOf(placed.world_from_node);
  light.tree_node = placed.tree_node;
  light.intensity = intensityOf(from);
  light.range_m = static_cast<float>(std::clamp(from.range, 0.0, 1e12));
  if (from.type == "spot") {
    const double outer = std::clamp(from.spot.outerConeAngle, 1e-3, glm::half_pi<double>());
    const double inner = std::clamp(from.spot.innerConeAngle, 0.0, outer - 1e-4);
    light.inner_cone_cos = static_cast<float>(std::cos(inner));
    light.outer_cone_cos = static_cast<float>(std::cos(outer));
  }
  return light;
}

double brightest(const glm::vec3& colour) {
  return std::max({colour.r, colour.g, colour.b});
}

// What arrives of a light in the middle of the scene, in lux.
double illuminanceAtCentre(const DirectionalLight& light, const BoundingSphere& /*scene*/) {
  return brightest(light.radiance);
}

double illuminanceAtCentre(const PointLight& light, const BoundingSphere& scene) {
  // A lamp inside the scene lights surfaces nearer than the centre.
  const double distance = std::max(glm::distance(light.p_world, scene.centre), 0.5 * scene.radius_m);
  return brightest(light.intensity) / std::max(distance * distance, 1e-12);
}

template <class Light>
struct FoundLight {
  std::string name;
  Light light;
  double illuminance = 0.0;
};

// All of one kind, in the file's order.
template <class Light>
using FoundLights = std::vector<FoundLight<Light>>;

std::string leftOutNote(std::vector<std::string> names, std::size_t found_count, const std::string& kind) {
  constexpr std::size_t kMostNamed = 4;
  const std::size_t count = names.size();
  if (count > kMostNamed + 1) {
    names.resize(kMostNamed);
    names.push_back(fmt::format("{} more", count - kMostNamed));
  }
  return fmt::format("{} of {} {} lights left out, the dimmest in the middle of the scene: {}.", count,
                     found_count, kind, joinNames(names));
}

// As many as are drawn, the brightest, in the file's order: the first directional one casts the shadow.
template <class Light>
std::vector<Light> keepBrightest(const FoundLights<Light>& found, const std::string& kind, Scene& scene) {
  std::vector<std::size_t> brightest_first(found.size());
  std::iota(brightest_first.begin(), brightest_first.end(), std::size_t{0});
  std::ranges::stable_sort(brightest_first, std::greater(),
                           [&](std::size_t i) { return found[i].illuminance; });
  brightest_first.resize(std::min(brightest_first.size(), kMaxLightsOfAKind));
  std::vector<Light> kept;
  std::vector<std::string> left_out;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (std::ranges::find(brightest_first, i) != brightest_first.end()) {
      kept.push_back(found[i].light);
    } else {
      left_out.push_back(found[i].name);
    }
  }
  if (!left_out.empty()) {
    scene.notes.push_back(leftOutNote(std::move(left_out), found.size(), kind));
  }
  return kept;
}

void dimToImage(Scene& scene) {
  constexpr double kTooBright = 30.0;  // a white wall would be ten times as bright as white
  constexpr double kWanted = 3.0;
  const BoundingSphere sphere = boundingSphere(scene);
  double illuminance = 0.0;
  for (const DirectionalLight& light : scene.directional_lights) {
    illuminance += illuminanceAtCentre(light, sphere);
  }
  for (const PointLight& light : scene.point_lights) {
    illuminance += illuminanceAtCentre(light, sphere);
  }
  if (illuminance <= kTooBright) {
    return;
  }
  const auto scale = static_cast<float>(kWanted / illuminance);
  for (DirectionalLight& light : scene.directional_lights) {
    light.radiance *= scale;
  }
  for (PointLight& light : scene.point_lights) {
    light.intensity *= scale;
  }
  scene.notes.push_back(fmt::format(
      "The lights are dimmed to {:.2g} of what the file says; the image has no exposure.", scale));
}

}  // namespace

void buildLights(const GltfDocument& document, std::span<const PlacedNode> nodes, Scene& scene) {
  const BoundingSphere sphere = boundingSphere(scene);
  FoundLights<DirectionalLight> directional;
  FoundLights<PointLight> points;
  for (const PlacedNode& placed : nodes) {
    const tinygltf::Node& node = document.model->nodes[static_cast<std::size_t>(placed.node)];
    const tinygltf::Light* from = lightOf(*document.model, node);
    if (from == nullptr) {
      continue;
    }
    const std::string name = nameOf(*from, node, placed.node);
    if (from->type == "directional") {
      const DirectionalLight light{aheadOf(placed.world_from_node), intensityOf(*from), placed.tree_node};
      directional.push_back({name, light, illuminanceAtCentre(light, sphere)});
    } else {
      const PointLight light = pointLightOf(*from, placed);
      points.push_back({name, light, illuminanceAtCentre(light, sphere)});
    }
  }
  scene.directional_lights = keepBrightest(directional, "directional", scene);
  scene.point_lights = keepBrightest(points, "point and spot", scene);
  dimToImage(scene);
  if (!scene.directional_lights.empty()) {
    return;
  }
  const bool only_points = !scene.point_lights.empty();
  scene.directional_lights.push_back(
      {glm::normalize(glm::dvec3(-0.4, -1.0, -0.5)), glm::vec3(only_points ? 0.3F : 3.0F)});
  scene.notes.emplace_back(only_points
                               ? "The file has no directional light; a faint one is added."
                               : "The file has no light; a directional one from the front right is added.");
}

}  // namespace ssrkit
