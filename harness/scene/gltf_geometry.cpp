#include "scene/gltf_geometry.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <array>
#include <cmath>
#include <compare>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "scene/gltf_accessor.h"
#include "scene/gltf_primitive.h"
#include "scene/place_mesh.h"

namespace ssrkit {

namespace {

// What a draw call holds fixed: its textures, and whether texels are cut out of it. A shadow caster's shader
// discards or does not, by its range.
struct DrawState {
  std::array<int, 4> textures{};
  bool is_cut_out = false;

  auto operator<=>(const DrawState&) const = default;
};

// A moving mesh whose first vertex is counted from its group's.
struct MovingRun {
  std::size_t group = 0;
  MovingMesh mesh;
};

struct Group {
  int material_index = 0;
  std::vector<Vertex> vertices;
};

class GeometryBuilder {
 public:
  GeometryBuilder(GltfDocument& document, const GltfMaterials& materials)
      : document_(document), materials_(materials) {}

  Expected<void> addMesh(int mesh_index, const PlacedNode& placed) {
    const MeshTransform transform(placed.world_from_node);
    const tinygltf::Mesh& mesh = document_.model->meshes[static_cast<std::size_t>(mesh_index)];
    for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
      const auto primitive = cached(mesh_index, static_cast<int>(i));
      if (!primitive) {
        return tl::make_unexpected(primitive.error());
      }
      vertex_count_ += (*primitive)->triangles.size();
      if (vertex_count_ > kMaxVertices) {
        return document_.source.refuse("",
                                       fmt::format("the scene has more than {} triangles", kMaxVertices / 3));
      }
      const std::string place = fmt::format("meshes[{}].primitives[{}]", mesh_index, i);
      if (auto added = placed.tree_node >= 0 ? addMoving(*primitive, transform, placed.tree_node, place)
                                             : addTriangles(**primitive, transform, place);
          !added) {
        return added;
      }
    }
    return {};
  }

  Expected<void> finish(Scene& scene, std::vector<MovingMesh>& moving) {
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      Group& group = groups_[i];
      for (MovingRun& run : moving_) {
        if (run.group == i) {
          run.mesh.first_vertex += static_cast<std::uint32_t>(scene.vertices.size());
          moving.push_back(run.mesh);
        }
      }
      scene.ranges.push_back({static_cast<std::uint32_t>(scene.vertices.size()),
                              static_cast<std::uint32_t>(group.vertices.size()), group.material_index});
      scene.vertices.insert(scene.vertices.end(), group.vertices.begin(), group.vertices.end());
      group.vertices = {};
    }
    if (scene.vertices.empty()) {
      const bool others = document_.tally.non_triangle_primitives > 0;
      return document_.source.refuse("", others ? "the scene has no triangle to draw, only points or lines"
                                                : "the scene has no triangle to draw");
    }
    return {};
  }

 private:
  // A mesh that many nodes show is read once.
  Expected<std::shared_ptr<const MeshTriangles>> cached(int mesh, int primitive) {
    const std::pair key(mesh, primitive);
    if (const auto known = primitives_.find(key); known != primitives_.end()) {
      return known->second;
    }
    auto read = readPrimitive(document_, materials_, mesh, primitive);
    if (!read) {
      return tl::make_unexpected(read.error());
    }
    read_count_ += read->positions.size() + read->triangles.size();
    if (read_count_ > 4 * kMaxVertices) {
      return document_.source.refuse("meshes",
                                     fmt::format("they hold more than {} vertices", 4 * kMaxVertices));
    }
    auto kept = std::make_shared<const MeshTriangles>(*std::move(read));
    primitives_.emplace(key, kept);
    return kept;
  }

  std::size_t groupOf(int material_index) {
    const Material& material = materials_.materials[static_cast<std::size_t>(material_index)];
    const DrawState state{.textures = {material.base_colour_texture, material.metallic_roughness_texture,
                                       material.normal_texture, material.emissive_texture},
                          .is_cut_out = material.alpha_mode != AlphaMode::kOpaque};
    const auto [known, is_new] = group_indices_.emplace(state, groups_.size());
    if (is_new) {
      groups_.push_back({material_index, {}});
    }
    return known->second;
  }

  // Refuses corners that single precision cannot hold.
  [[nodiscard]] Expected<void> checkFinite(const PlacedTriangle& placed, const std::string& place) const {
    for (std::size_t c = 0; c < 3; ++c) {
      const glm::vec3& p_world = placed.vertices[c].p_world;
      if (!std::isfinite(p_world.x + p_world.y + p_world.z)) {
        return document_.source.refuse(
            place, fmt::format("vertex {} is not finite in the world", placed.corners[c]));
      }
    }
    return {};
  }

  Expected<void> addTriangles(const MeshTriangles& mesh, const MeshTransform& transform,
                              const std::string& place) {
    if (mesh.triangles.empty()) {
      return {};
    }
    std::vector<Vertex>& out = groups_[groupOf(mesh.material_index)].vertices;
    for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
      std::size_t mended_normals = 0;
      const PlacedTriangle placed = placeTriangle(mesh, i, transform, mended_normals);
      if (auto finite = checkFinite(placed, place); !finite) {
        return finite;
      }
      if (!placed.has_area) {
        ++document_.tally.degenerate_triangles;
        continue;
      }
      document_.tally.mended_normals += mended_normals;
      out.insert(out.end(), placed.vertices.begin(), placed.vertices.end());
    }
    return {};
  }

  // All of a moving mesh's triangles stay: one that has no area now may have some later.
  Expected<void> addMoving(const std::shared_ptr<const MeshTriangles>& mesh, const MeshTransform& transform,
                           int tree_node, const std::string& place) {
    if (mesh->triangles.empty()) {
      return {};
    }
    const std::size_t group = groupOf(mesh->material_index);
    std::vector<Vertex>& out = groups_[group].vertices;
    moving_.push_back({group, {tree_node, static_cast<std::uint32_t>(out.size()), mesh}});
    for (std::size_t i = 0; i + 2 < mesh->triangles.size(); i += 3) {
      const PlacedTriangle placed = placeTriangle(*mesh, i, transform, document_.tally.mended_normals);
      if (auto finite = checkFinite(placed, place); !finite) {
        return finite;
      }
      out.insert(out.end(), placed.vertices.begin(), placed.vertices.end());
    }
    return {};
  }

  GltfDocument& document_;
  const GltfMaterials& materials_;
  std::map<std::pair<int, int>, std::shared_ptr<const MeshTriangles>> primitives_;
  std::map<DrawState, std::size_t> group_indices_;
  std::vector<Group> groups_;
  std::vector<MovingRun> moving_;
  std::size_t vertex_count_ = 0;
  std::size_t read_count_ = 0;
};

}  // namespace

Expected<void> buildGeometry(GltfDocument& document, const GltfMaterials& materials,
                             std::span<const PlacedNode> nodes, Scene& scene,
                             std::vector<MovingMesh>& moving) {
  GeometryBuilder builder(document, materials);
  for (const PlacedNode& placed : nodes) {
    const tinygltf::Node& node = document.model->nodes[static_cast<std::size_t>(placed.node)];
    if (node.mesh < 0) {
      continue;
    }
    PlacedNode mesh_node = placed;
    if (node.skin >= 0) {
      ++document.tally.skinned_nodes;
      mesh_node.tree_node = -1;  // its joints move it, not its node
    }
    if (auto added = builder.addMesh(node.mesh, mesh_node); !added) {
      return added;
    }
  }
  return builder.finish(scene, moving);
}

}  // namespace ssrkit
