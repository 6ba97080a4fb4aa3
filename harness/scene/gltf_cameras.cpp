#include "scene/gltf_cameras.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <vector>

#include "base/text.h"
#include "scene/clean_name.h"
#include "scene/framing.h"

namespace ssrkit {

namespace {

constexpr std::string_view kOrthographic = "orthographic cameras are not supported";

Expected<SceneCamera> readCamera(GltfDocument& document, const PlacedNode& placed, const Scene& scene) {
  const tinygltf::Node& node = document.model->nodes[static_cast<std::size_t>(placed.node)];
  const tinygltf::Camera& from = document.model->cameras[static_cast<std::size_t>(node.camera)];
  const auto& lens = from.perspective;
  const std::string place = fmt::format("cameras[{}]", node.camera);
  if (!(lens.yfov > 0.0 && lens.yfov < glm::pi<double>())) {
    return document.source.refuse(place, fmt::format("yfov is {} and must lie between 0 and pi", lens.yfov));
  }
  if (!(lens.znear > 0.0) || (lens.zfar != 0.0 && !(lens.zfar > lens.znear))) {
    return document.source.refuse(
        place,
        fmt::format("znear is {} and zfar is {}; they must satisfy 0 < znear < zfar", lens.znear, lens.zfar));
  }
  SceneCamera camera;
  camera.name = cleanName(from.name.empty() ? node.name : from.name);
  if (camera.name.empty()) {
    camera.name = fmt::format("camera {}", node.camera);
  }
  const auto view_from_world = viewFromWorld(placed.world_from_node);
  if (!view_from_world) {
    return document.source.refuse(fmt::format("nodes[{}]", placed.node),
                                  "its transform leaves its camera no direction");
  }
  camera.view_from_world = *view_from_world;
  camera.previous_view_from_world = *view_from_world;
  camera.tree_node = placed.tree_node;
  camera.fov_y_rad = lens.yfov;
  if (lens.aspectRatio > 0.0) {
    camera.aspect = lens.aspectRatio;
  }
  camera.near_m = lens.znear;
  // glTF's infinite projection has no last depth, and the kit's stored depth needs one.
  camera.far_follows_scene = lens.zfar == 0.0;
  camera.far_m = camera.far_follows_scene ? farBehindScene(scene, camera) : lens.zfar;
  return camera;
}

struct FoundCameras {
  std::vector<SceneCamera> perspective;
  std::vector<std::string> orthographic;
};

Expected<FoundCameras> findCameras(GltfDocument& document, std::span<const PlacedNode> nodes,
                                   const Scene& scene) {
  FoundCameras found;
  for (const PlacedNode& placed : nodes) {
    const tinygltf::Node& node = document.model->nodes[static_cast<std::size_t>(placed.node)];
    if (node.camera < 0) {
      continue;
    }
    const tinygltf::Camera& camera = document.model->cameras[static_cast<std::size_t>(node.camera)];
    if (camera.type != "perspective") {
      found.orthographic.push_back(cleanName(camera.name.empty() ? node.name : camera.name));
      continue;
    }
    auto read = readCamera(document, placed, scene);
    if (!read) {
      return tl::make_unexpected(read.error());
    }
    found.perspective.push_back(*std::move(read));
  }
  return found;
}

Expected<void> moveToFront(const GltfDocument& document, const FoundCameras& found, const std::string& name,
                           std::vector<SceneCamera>& cameras) {
  const auto wanted = std::find_if(cameras.begin(), cameras.end(),
                                   [&](const SceneCamera& camera) { return camera.name == name; });
  if (wanted != cameras.end()) {
    std::rotate(cameras.begin(), wanted, wanted + 1);
    return {};
  }
  if (std::find(found.orthographic.begin(), found.orthographic.end(), name) != found.orthographic.end()) {
    return document.source.refuse("",
                                  fmt::format("the camera '{}' is orthographic, and {}", name, kOrthographic),
                                  "name a perspective camera");
  }
  std::vector<std::string> names;
  names.reserve(cameras.size());
  for (const SceneCamera& camera : cameras) {
    names.push_back(camera.name);
  }
  const auto nearest = nearestName(name, names);
  return document.source.refuse(
      "", fmt::format("it has no camera '{}'", cleanName(name)),
      nearest ? fmt::format("did you mean '{}'?", *nearest) : "its cameras are " + joinNames(names));
}

}  // namespace

Expected<void> buildCameras(GltfDocument& document, std::span<const PlacedNode> nodes,
                            const std::string& camera_name, Scene& scene) {
  auto found = findCameras(document, nodes, scene);
  if (!found) {
    return tl::make_unexpected(found.error());
  }
  scene.cameras = found->perspective;
  if (scene.cameras.empty() && !found->orthographic.empty()) {
    return document.source.refuse("cameras",
                                  fmt::format("its only camera is orthographic, and {}", kOrthographic),
                                  "give it a perspective camera, or none");
  }
  if (!found->orthographic.empty()) {
    scene.notes.push_back(
        fmt::format("{} orthographic camera(s) left out: {}.", found->orthographic.size(), kOrthographic));
  }
  if (scene.cameras.empty()) {
    scene.cameras.push_back(framedCamera(boundingSphere(scene)));
    scene.notes.emplace_back("The file has no camera; one is framed around the whole scene.");
  }
  return camera_name.empty() ? Expected<void>{} : moveToFront(document, *found, camera_name, scene.cameras);
}

}  // namespace ssrkit
