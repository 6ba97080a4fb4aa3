#include "scene/gltf_lights.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <optional>

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

glm::vec3 intensityOf(const tinygltf::Light& light) {
  constexpr double kMaxIntensity = 1e12;
  glm::vec3 colour(1.0F);
  for (int i = 0; i < 3 && light.color.size() == 3; ++i) {
    colour[i] = static_cast<float>(std::clamp(light.color[static_cast<std::size_t>(i)], 0.0, 1.0));
  }
  return colour * static_cast<float>(std::clamp(light.intensity, 0.0, kMaxIntensity));
}

void addLight(const tinygltf::Light& from, const PlacedNode& placed, Scene& scene) {
  if (from.type == "directional") {
    scene.directional_lights.push_back(
        {aheadOf(placed.world_from_node), intensityOf(from), placed.tree_node});
    return;
  }
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
  scene.point_lights.push_back(light);
}

double brightest(const glm::vec3& colour) {
  return std::max({colour.r, colour.g, colour.b});
}

// What arrives in the middle of the scene, in lux.
double illuminanceAtCentre(const Scene& scene) {
  const BoundingSphere sphere = boundingSphere(scene);
  double illuminance = 0.0;
  for (const DirectionalLight& light : scene.directional_lights) {
    illuminance += brightest(light.radiance);
  }
  for (const PointLight& light : scene.point_lights) {
    // A lamp inside the scene lights surfaces nearer than the centre.
    const double distance = std::max(glm::distance(light.p_world, sphere.centre), 0.5 * sphere.radius_m);
    illuminance += brightest(light.intensity) / std::max(distance * distance, 1e-12);
  }
  return illuminance;
}

void dimToImage(Scene& scene) {
  constexpr double kTooBright = 30.0;  // a white wall would be ten times as bright as white
  constexpr double kWanted = 3.0;
  const double illuminance = illuminanceAtCentre(scene);
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
  for (const PlacedNode& placed : nodes) {
    const tinygltf::Node& node = document.model->nodes[static_cast<std::size_t>(placed.node)];
    if (const tinygltf::Light* light = lightOf(*document.model, node)) {
      addLight(*light, placed, scene);
    }
  }
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
