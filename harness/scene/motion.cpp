#include "scene/motion.h"

#include <fmt/format.h>

#include <cmath>

#include "scene/framing.h"
#include "scene/place_mesh.h"

namespace ssrkit {

namespace {

struct Poses {
  std::vector<glm::dmat4> now;  // by tree node
  std::vector<glm::dmat4> previous;
};

bool isFinite(const glm::vec3& vector) {
  return std::isfinite(vector.x + vector.y + vector.z);
}

Expected<void> poseMesh(const MovingMesh& moving, const Poses& poses, const NodeTree& tree, Scene& scene) {
  const auto node = static_cast<std::size_t>(moving.tree_node);
  const MeshTransform now(poses.now[node]);
  const MeshTransform previous(poses.previous[node]);
  const MeshTriangles& mesh = *moving.mesh;
  std::size_t mended_normals = 0;
  for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
    PlacedTriangle placed = placeTriangle(mesh, i, now, mended_normals);
    for (std::size_t c = 0; c < 3; ++c) {
      Vertex& vertex = placed.vertices[c];
      vertex.p_previous_world = placedPosition(mesh, placed.corners[c], previous);
      if (!isFinite(vertex.p_world) || !isFinite(vertex.p_previous_world)) {
        return tree.source.refuse(tree.places[node],
                                  "its animation takes its mesh out of what single precision holds");
      }
      scene.vertices[moving.first_vertex + i + c] = vertex;
    }
  }
  return {};
}

Expected<void> poseCameras(const Poses& poses, const NodeTree& tree, Scene& scene) {
  for (SceneCamera& camera : scene.cameras) {
    if (camera.tree_node < 0) {
      continue;
    }
    const auto node = static_cast<std::size_t>(camera.tree_node);
    const auto now = viewFromWorld(poses.now[node]);
    const auto previous = viewFromWorld(poses.previous[node]);
    if (!now || !previous) {
      return tree.source.refuse(tree.places[node], "its animation leaves its camera no direction");
    }
    camera.view_from_world = *now;
    camera.previous_view_from_world = *previous;
  }
  for (SceneCamera& camera : scene.cameras) {
    if (camera.far_follows_scene) {
      camera.far_m = farBehindScene(scene, camera);
    }
  }
  return {};
}

void poseLights(const Poses& poses, Scene& scene) {
  for (DirectionalLight& light : scene.directional_lights) {
    if (light.tree_node >= 0) {
      light.direction_world = aheadOf(poses.now[static_cast<std::size_t>(light.tree_node)]);
    }
  }
  for (PointLight& light : scene.point_lights) {
    if (light.tree_node >= 0) {
      const glm::dmat4& place = poses.now[static_cast<std::size_t>(light.tree_node)];
      light.p_world = glm::dvec3(place[3]);
      light.direction_world = aheadOf(place);
    }
  }
}

}  // namespace

Expected<void> poseScene(Scene& scene, double time_s, double previous_time_s) {
  if (scene.motion == nullptr) {
    return {};
  }
  const NodeTree& tree = scene.motion->tree;
  auto now = worldFromNodes(tree, time_s);
  if (!now) {
    return tl::make_unexpected(now.error());
  }
  auto previous = worldFromNodes(tree, previous_time_s);
  if (!previous) {
    return tl::make_unexpected(previous.error());
  }
  const Poses poses{*std::move(now), *std::move(previous)};
  for (const MovingMesh& moving : scene.motion->meshes) {
    if (auto posed = poseMesh(moving, poses, tree, scene); !posed) {
      return posed;
    }
  }
  poseLights(poses, scene);
  return poseCameras(poses, tree, scene);
}

}  // namespace ssrkit
