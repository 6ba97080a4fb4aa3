// What moves in a scene, and the scene at a time.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/error.h"
#include "scene/mesh_triangles.h"
#include "scene/node_tree.h"
#include "scene/scene.h"

namespace ssrkit {

// One primitive at one moving node: a run of the scene's vertices, three for each of the mesh's triangles.
struct MovingMesh {
  int tree_node = 0;
  std::uint32_t first_vertex = 0;
  std::shared_ptr<const MeshTriangles> mesh;
};

struct SceneMotion {
  NodeTree tree;
  std::vector<MovingMesh> meshes;
};

// Puts the moving meshes, cameras and lights where they are at `time_s`, and their previous places where they
// were at `previous_time_s`. Nothing else is touched, so it costs what moves. Fails on places that are not
// finite.
[[nodiscard]] Expected<void> poseScene(Scene& scene, double time_s, double previous_time_s);

}  // namespace ssrkit
