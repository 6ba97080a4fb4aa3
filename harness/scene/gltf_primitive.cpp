#include "scene/gltf_primitive.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "scene/gltf_accessor.h"
#include "scene/tangents.h"

namespace ssrkit {

namespace {

template <class T>
std::vector<T> grouped(const std::vector<float>& values) {
  constexpr std::size_t kComponents = sizeof(T) / sizeof(float);
  std::vector<T> groups(values.size() / kComponents);
  for (std::size_t i = 0; i < values.size(); ++i) {
    groups[i / kComponents][static_cast<int>(i % kComponents)] = values[i];
  }
  return groups;
}

template <class T>
bool isFinite(const T& vector) {
  for (int i = 0; i < T::length(); ++i) {
    if (!std::isfinite(vector[i])) {
      return false;
    }
  }
  return true;
}

// One attribute; empty when the primitive does not have it.
template <class T>
Expected<std::vector<T>> readAttribute(const GltfDocument& document, const tinygltf::Primitive& primitive,
                                       const std::string& name, std::size_t vertex_count,
                                       const std::string& place) {
  const auto found = primitive.attributes.find(name);
  if (found == primitive.attributes.end()) {
    return std::vector<T>();
  }
  const std::string here = fmt::format("{}.attributes.{}", place, name);
  const auto values = readFloats(document, found->second, static_cast<int>(T::length()), here);
  if (!values) {
    return tl::make_unexpected(values.error());
  }
  std::vector<T> attribute = grouped<T>(*values);
  if (attribute.size() != vertex_count) {
    return document.source.refuse(
        here, fmt::format("it has {} elements and POSITION has {}", attribute.size(), vertex_count));
  }
  return attribute;
}

Expected<std::vector<glm::vec3>> readPositions(const GltfDocument& document,
                                               const tinygltf::Primitive& primitive,
                                               const std::string& place) {
  const auto found = primitive.attributes.find("POSITION");
  if (found == primitive.attributes.end()) {
    return document.source.refuse(place + ".attributes", "'POSITION' is missing");
  }
  const std::string here = place + ".attributes.POSITION";
  const auto values = readFloats(document, found->second, 3, here);
  if (!values) {
    return tl::make_unexpected(values.error());
  }
  std::vector<glm::vec3> positions = grouped<glm::vec3>(*values);
  const auto bad = std::find_if_not(positions.begin(), positions.end(), isFinite<glm::vec3>);
  if (bad != positions.end()) {
    return document.source.refuse(fmt::format("{} (accessors[{}])", here, found->second),
                                  fmt::format("vertex {} is not finite", bad - positions.begin()));
  }
  return positions;
}

// The corners of the triangles, from a list, a strip or a fan (glTF 2.0, 3.7.2.1); what is not a whole
// triangle at the end of a list is dropped.
std::vector<std::uint32_t> triangleCorners(int mode, const std::vector<std::uint32_t>& corners) {
  if (mode == TINYGLTF_MODE_TRIANGLES) {
    return {corners.begin(), corners.end() - static_cast<std::ptrdiff_t>(corners.size() % 3)};
  }
  std::vector<std::uint32_t> triangles;
  triangles.reserve(3 * corners.size());
  for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
    const bool odd = i % 2 == 1;
    const std::size_t first = mode == TINYGLTF_MODE_TRIANGLE_FAN ? i + 1 : i;
    const std::size_t second = mode == TINYGLTF_MODE_TRIANGLE_FAN ? i + 2 : odd ? i + 2 : i + 1;
    const std::size_t third = mode == TINYGLTF_MODE_TRIANGLE_FAN ? 0 : odd ? i + 1 : i + 2;
    triangles.insert(triangles.end(), {corners[first], corners[second], corners[third]});
  }
  return triangles;
}

bool drawsTriangles(int mode) {
  return mode == TINYGLTF_MODE_TRIANGLES || mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
         mode == TINYGLTF_MODE_TRIANGLE_FAN;
}

Expected<std::vector<std::uint32_t>> readTriangles(GltfDocument& document,
                                                   const tinygltf::Primitive& primitive,
                                                   std::size_t vertex_count, const std::string& place) {
  std::vector<std::uint32_t> corners;
  if (primitive.indices >= 0) {
    auto indices = readIndices(document, primitive.indices, vertex_count, place + ".indices");
    if (!indices) {
      return tl::make_unexpected(indices.error());
    }
    corners = *std::move(indices);
  } else {
    corners.resize(vertex_count);
    std::iota(corners.begin(), corners.end(), 0U);
  }
  const std::size_t spare = primitive.mode == TINYGLTF_MODE_TRIANGLES ? corners.size() % 3 : 0;
  document.tally.incomplete_triangles += spare > 0 ? 1U : 0U;
  return triangleCorners(primitive.mode, corners);
}

// Texture coordinates as the material's textures see them.
void transformUvs(const UvSource& source, GltfTally& tally, std::vector<glm::vec2>& uvs) {
  for (glm::vec2& uv : uvs) {
    uv = glm::vec2(source.uv_from_file * glm::vec3(uv, 1.0F));
    if (!isFinite(uv)) {
      uv = glm::vec2(0.0F);
      ++tally.mended_uvs;
    }
  }
}

// Gives every triangle corners of its own with the face's normal: what a normal map on a mesh without normals
// needs.
void makeFlat(MeshTriangles& mesh) {
  MeshTriangles flat;
  for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
    const std::uint32_t* corners = &mesh.triangles[i];
    const glm::dvec3 first(mesh.positions[corners[0]]);
    const glm::dvec3 normal = glm::cross(glm::dvec3(mesh.positions[corners[1]]) - first,
                                         glm::dvec3(mesh.positions[corners[2]]) - first);
    for (std::size_t c = 0; c < 3; ++c) {
      flat.positions.push_back(mesh.positions[corners[c]]);
      flat.uvs.push_back(mesh.uvs[corners[c]]);
      flat.normals.emplace_back(normal / std::max(glm::length(normal), std::numeric_limits<double>::min()));
      flat.triangles.push_back(static_cast<std::uint32_t>(flat.triangles.size()));
    }
  }
  flat.material_index = mesh.material_index;
  mesh = std::move(flat);
}

Expected<void> readSurface(GltfDocument& document, const GltfMaterials& materials,
                           const tinygltf::Primitive& primitive, const std::string& place,
                           MeshTriangles& mesh) {
  const std::size_t count = mesh.positions.size();
  const UvSource& uv_source = materials.uv_sources[static_cast<std::size_t>(mesh.material_index)];
  auto normals = readAttribute<glm::vec3>(document, primitive, "NORMAL", count, place);
  if (!normals) {
    return tl::make_unexpected(normals.error());
  }
  auto uvs =
      readAttribute<glm::vec2>(document, primitive, fmt::format("TEXCOORD_{}", uv_source.set), count, place);
  if (!uvs) {
    return tl::make_unexpected(uvs.error());
  }
  mesh.normals = *std::move(normals);
  mesh.uvs = *std::move(uvs);
  transformUvs(uv_source, document.tally, mesh.uvs);
  if (materials.materials[static_cast<std::size_t>(mesh.material_index)].normal_texture < 0 ||
      mesh.uvs.empty()) {
    return {};
  }
  if (mesh.normals.empty()) {
    makeFlat(mesh);
    mesh.tangents = tangentsFromUv(mesh.positions, mesh.normals, mesh.uvs, mesh.triangles);
    return {};
  }
  auto tangents = readAttribute<glm::vec4>(document, primitive, "TANGENT", count, place);
  if (!tangents) {
    return tl::make_unexpected(tangents.error());
  }
  mesh.tangents = *std::move(tangents);
  if (mesh.tangents.empty()) {
    mesh.tangents = tangentsFromUv(mesh.positions, mesh.normals, mesh.uvs, mesh.triangles);
  }
  return {};
}

}  // namespace

Expected<MeshTriangles> readPrimitive(GltfDocument& document, const GltfMaterials& materials, int mesh_index,
                                      int primitive_index) {
  const tinygltf::Primitive& primitive = document.model->meshes[static_cast<std::size_t>(mesh_index)]
                                             .primitives[static_cast<std::size_t>(primitive_index)];
  const std::string place = fmt::format("meshes[{}].primitives[{}]", mesh_index, primitive_index);
  MeshTriangles mesh;
  if (!drawsTriangles(primitive.mode)) {
    if (primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN) {
      return document.source.refuse(place, fmt::format("its mode {} is not one of glTF's", primitive.mode));
    }
    ++document.tally.non_triangle_primitives;
    return mesh;
  }
  document.tally.morphed_primitives += primitive.targets.empty() ? 0U : 1U;
  document.tally.coloured_primitives += primitive.attributes.count("COLOR_0");
  mesh.material_index =
      primitive.material >= 0 ? primitive.material : static_cast<int>(materials.materials.size()) - 1;
  auto positions = readPositions(document, primitive, place);
  if (!positions) {
    return tl::make_unexpected(positions.error());
  }
  mesh.positions = *std::move(positions);
  auto triangles = readTriangles(document, primitive, mesh.positions.size(), place);
  if (!triangles) {
    return tl::make_unexpected(triangles.error());
  }
  mesh.triangles = *std::move(triangles);
  if (auto surface = readSurface(document, materials, primitive, place, mesh); !surface) {
    return tl::make_unexpected(surface.error());
  }
  return mesh;
}

}  // namespace ssrkit
