#include "scene/gltf_geometry.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "scene/gltf_accessor.h"
#include "scene/gltf_primitive.h"

namespace ssrkit {

namespace {

using TextureSet = std::array<int, 4>;

struct Group {
  int material_index = 0;
  std::vector<Vertex> vertices;
};

// Mesh to world: positions by the matrix, normals by its cofactors, which is the inverse transpose without
// the division that a flattened mesh would not survive.
struct MeshTransform {
  glm::dmat4 positions;
  glm::dmat3 directions;
  glm::dmat3 normals;
  double handedness = 1.0;  // -1: the transform mirrors, so corners and bitangents change sides

  explicit MeshTransform(const glm::dmat4& world_from_node)
      : positions(world_from_node), directions(world_from_node) {
    const glm::dmat3& m = directions;
    handedness = glm::dot(glm::cross(m[0], m[1]), m[2]) < 0.0 ? -1.0 : 1.0;
    normals = glm::dmat3(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])) * handedness;
  }
};

// The vector with length 1, or `otherwise` where it has none.
glm::vec3 unitOr(const glm::dvec3& vector, const glm::dvec3& otherwise, std::size_t* mended) {
  const double length = glm::length(vector);
  if (length > 0.0 && std::isfinite(length)) {
    return glm::vec3(vector / length);
  }
  if (mended != nullptr) {
    ++*mended;
  }
  return glm::vec3(otherwise);
}

class GeometryBuilder {
 public:
  GeometryBuilder(GltfDocument& document, const GltfMaterials& materials)
      : document_(document), materials_(materials) {}

  Expected<void> addMesh(int mesh_index, const glm::dmat4& world_from_node) {
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
      if (auto added = addTriangles(**primitive, MeshTransform(world_from_node), mesh_index, i); !added) {
        return added;
      }
    }
    return {};
  }

  Expected<void> finish(Scene& scene) {
    for (Group& group : groups_) {
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
  Expected<const MeshTriangles*> cached(int mesh, int primitive) {
    const std::pair key(mesh, primitive);
    if (const auto known = primitives_.find(key); known != primitives_.end()) {
      return &known->second;
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
    return &primitives_.emplace(key, *std::move(read)).first->second;
  }

  Group& groupOf(int material_index) {
    const Material& material = materials_.materials[static_cast<std::size_t>(material_index)];
    const TextureSet textures{material.base_colour_texture, material.metallic_roughness_texture,
                              material.normal_texture, material.emissive_texture};
    const auto [known, is_new] = group_indices_.emplace(textures, groups_.size());
    if (is_new) {
      groups_.push_back({material_index, {}});
    }
    return groups_[known->second];
  }

  Expected<void> addTriangles(const MeshTriangles& mesh, const MeshTransform& transform, int mesh_index,
                              std::size_t primitive_index) {
    if (mesh.triangles.empty()) {
      return {};
    }
    Group& group = groupOf(mesh.material_index);
    for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
      std::array<std::uint32_t, 3> corners{mesh.triangles[i], mesh.triangles[i + 1], mesh.triangles[i + 2]};
      if (transform.handedness < 0.0) {
        std::swap(corners[1], corners[2]);
      }
      std::array<glm::vec3, 3> p_world;
      for (std::size_t c = 0; c < 3; ++c) {
        p_world[c] = glm::vec3(transform.positions * glm::dvec4(mesh.positions[corners[c]], 1.0));
        if (!std::isfinite(p_world[c].x + p_world[c].y + p_world[c].z)) {
          return document_.source.refuse(
              fmt::format("meshes[{}].primitives[{}]", mesh_index, primitive_index),
              fmt::format("vertex {} is not finite in the world", corners[c]));
        }
      }
      addTriangle(mesh, transform, corners, p_world, group.vertices);
    }
    return {};
  }

  void addTriangle(const MeshTriangles& mesh, const MeshTransform& transform,
                   const std::array<std::uint32_t, 3>& corners, const std::array<glm::vec3, 3>& p_world,
                   std::vector<Vertex>& out) {
    const glm::dvec3 edge1 = glm::dvec3(p_world[1]) - glm::dvec3(p_world[0]);
    const glm::dvec3 edge2 = glm::dvec3(p_world[2]) - glm::dvec3(p_world[0]);
    const glm::dvec3 cross = glm::cross(edge1, edge2);
    // Below this sine of the angle between its edges a triangle is rounding of its corners.
    constexpr double kSmallestSine = 1e-9;
    const double area = glm::length(cross);
    if (!(area > kSmallestSine * glm::length(edge1) * glm::length(edge2))) {
      ++document_.tally.degenerate_triangles;
      return;
    }
    const glm::dvec3 face_normal = cross / area;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t corner = corners[c];
      Vertex vertex{};
      vertex.p_world = p_world[c];
      vertex.face_normal_world = glm::vec3(face_normal);
      vertex.normal_world = mesh.normals.empty()
                                ? vertex.face_normal_world
                                : unitOr(transform.normals * glm::dvec3(mesh.normals[corner]), face_normal,
                                         &document_.tally.mended_normals);
      vertex.tangent_world = glm::vec4(1.0F, 0.0F, 0.0F, 1.0F);
      if (!mesh.tangents.empty()) {
        const glm::vec4& tangent = mesh.tangents[corner];
        const double side = (tangent.w < 0.0F ? -1.0 : 1.0) * transform.handedness;
        vertex.tangent_world = glm::vec4(
            unitOr(transform.directions * glm::dvec3(tangent), edge1 / glm::length(edge1), nullptr), side);
      }
      vertex.uv = mesh.uvs.empty() ? glm::vec2(0.0F) : mesh.uvs[corner];
      vertex.material_index = static_cast<float>(mesh.material_index);
      out.push_back(vertex);
    }
  }

  GltfDocument& document_;
  const GltfMaterials& materials_;
  std::map<std::pair<int, int>, MeshTriangles> primitives_;
  std::map<TextureSet, std::size_t> group_indices_;
  std::vector<Group> groups_;
  std::size_t vertex_count_ = 0;
  std::size_t read_count_ = 0;
};

}  // namespace

Expected<void> buildGeometry(GltfDocument& document, const GltfMaterials& materials,
                             std::span<const PlacedNode> nodes, Scene& scene) {
  GeometryBuilder builder(document, materials);
  for (const PlacedNode& placed : nodes) {
    const tinygltf::Node& node = document.model->nodes[static_cast<std::size_t>(placed.node)];
    if (node.mesh < 0) {
      continue;
    }
    document.tally.skinned_nodes += node.skin >= 0 ? 1U : 0U;
    if (auto added = builder.addMesh(node.mesh, placed.world_from_node); !added) {
      return added;
    }
  }
  return builder.finish(scene);
}

}  // namespace ssrkit
