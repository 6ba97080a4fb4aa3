#include "plane_scene.h"

#include <cmath>
#include <numbers>

namespace ssrkit {

PlaneScene::PlaneScene(const glm::dvec3& light_direction) {
  scene_.name = "planes";
  scene_.directional_lights = {
      {.direction_world = glm::normalize(light_direction), .radiance = glm::vec3(3.0F)}};
}

void PlaneScene::beginRange(const Material& material) {
  scene_.ranges.push_back({.first_vertex = static_cast<std::uint32_t>(scene_.vertices.size()),
                           .vertex_count = 0,
                           .material_index = static_cast<int>(scene_.materials.size())});
  scene_.materials.push_back(material);
}

void PlaneScene::addTriangle(const std::array<glm::dvec3, 3>& corners,
                             const std::array<glm::dvec3, 3>& normals) {
  const glm::dvec3 crossed = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const glm::dvec3 face = glm::length(crossed) > 0.0 ? glm::normalize(crossed) : normals[0];
  for (std::size_t i = 0; i < 3; ++i) {
    scene_.vertices.push_back({.p_world = corners[i],
                               .normal_world = normals[i],
                               .tangent_world = {1, 0, 0, 1},
                               .uv = {0, 0},
                               .face_normal_world = face,
                               .material_index = static_cast<float>(scene_.ranges.back().material_index)});
  }
  scene_.ranges.back().vertex_count += 3;
}

PlaneScene& PlaneScene::quad(const Quad& quad, const Material& material) {
  beginRange(material);
  const glm::dvec3 normal = glm::normalize(glm::cross(quad.b - quad.a, quad.c - quad.a));
  addTriangle({quad.a, quad.b, quad.c}, {normal, normal, normal});
  addTriangle({quad.a, quad.c, quad.d}, {normal, normal, normal});
  return *this;
}

PlaneScene& PlaneScene::triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                                 const glm::dvec3& normal, const Material& material) {
  beginRange(material);
  addTriangle({a, b, c}, {normal, normal, normal});
  return *this;
}

PlaneScene& PlaneScene::box(const glm::dvec3& l, const glm::dvec3& g) {
  quad({{l.x, l.y, g.z}, {g.x, l.y, g.z}, {g.x, g.y, g.z}, {l.x, g.y, g.z}});
  quad({{g.x, l.y, l.z}, {l.x, l.y, l.z}, {l.x, g.y, l.z}, {g.x, g.y, l.z}});
  quad({{l.x, l.y, l.z}, {l.x, l.y, g.z}, {l.x, g.y, g.z}, {l.x, g.y, l.z}});
  quad({{g.x, l.y, g.z}, {g.x, l.y, l.z}, {g.x, g.y, l.z}, {g.x, g.y, g.z}});
  quad({{l.x, g.y, g.z}, {g.x, g.y, g.z}, {g.x, g.y, l.z}, {l.x, g.y, l.z}});
  return quad({{l.x, l.y, l.z}, {g.x, l.y, l.z}, {g.x, l.y, g.z}, {l.x, l.y, g.z}});
}

PlaneScene& PlaneScene::floor(double y, double extent_m) {
  return quad({{-extent_m, y, extent_m},
               {extent_m, y, extent_m},
               {extent_m, y, -extent_m},
               {-extent_m, y, -extent_m}});
}

PlaneScene faceted(const glm::dvec3& light_direction, const glm::dvec3& centre, double radius_m) {
  constexpr int kColumns = 48;
  constexpr int kRows = 24;
  PlaneScene planes(light_direction);
  planes.beginRange({});
  const auto normal = [](int column, int row) {
    const double phi = 2.0 * std::numbers::pi * column / kColumns;
    const double theta = std::numbers::pi * row / kRows;
    return glm::dvec3(std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi));
  };
  const auto add = [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    planes.addTriangle({centre + radius_m * a, centre + radius_m * b, centre + radius_m * c}, {a, b, c});
  };
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      add(normal(column, row), normal(column, row + 1), normal(column + 1, row + 1));
      add(normal(column, row), normal(column + 1, row + 1), normal(column + 1, row));
    }
  }
  return planes;
}

}  // namespace ssrkit
