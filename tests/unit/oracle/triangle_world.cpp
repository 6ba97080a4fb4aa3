#include "triangle_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/error.h"

namespace ssrkit::testing {

namespace {

void addVertex(Scene& scene, glm::vec3 p_world, glm::vec3 face_normal, glm::vec2 uv, int material) {
  scene.vertices.push_back({.p_world = p_world,
                            .normal_world = face_normal,
                            .tangent_world = {1.0F, 0.0F, 0.0F, 1.0F},
                            .uv = uv,
                            .face_normal_world = face_normal,
                            .material_index = static_cast<float>(material)});
}

void addCorners(Scene& scene, const std::array<glm::vec3, 3>& corners, const std::array<glm::vec2, 3>& uvs,
                int material) {
  const glm::vec3 cross = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const float area = glm::length(cross);
  for (std::size_t i = 0; i < 3; ++i) {
    addVertex(scene, corners.at(i), area > 0.0F ? cross / area : cross, uvs.at(i), material);
  }
}

void addFloor(Scene& scene, float z_near, float z_far) {
  addQuad(scene, {-12, -1, z_near}, {12, -1, z_near}, {12, -1, z_far}, {-12, -1, z_far});
}

void addWall(Scene& scene, float dist, float top) {
  addQuad(scene, {-12, -1, -dist}, {12, -1, -dist}, {12, top, -dist}, {-12, top, -dist});
}

}  // namespace

Scene emptyWorld() {
  Scene scene;
  scene.materials.emplace_back();
  return scene;
}

int addMaterial(Scene& scene, const Material& material) {
  scene.materials.push_back(material);
  return static_cast<int>(scene.materials.size()) - 1;
}

void addTriangle(Scene& scene, glm::vec3 a, glm::vec3 b, glm::vec3 c, int material) {
  addCorners(scene, {a, b, c}, {}, material);
}

void addQuad(Scene& scene, glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d, int material) {
  addCorners(scene, {a, b, c}, {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1)}, material);
  addCorners(scene, {a, c, d}, {glm::vec2(0, 0), glm::vec2(1, 1), glm::vec2(0, 1)}, material);
}

void addSphere(Scene& scene, glm::dvec3 centre, double radius_m, int rings, int material) {
  const auto at = [&](int ring, int slice) {
    const double polar = std::numbers::pi * ring / rings;
    const double azimuth = std::numbers::pi * slice / rings;
    return glm::vec3(centre + radius_m * glm::dvec3(std::sin(polar) * std::cos(azimuth), std::cos(polar),
                                                    std::sin(polar) * -std::sin(azimuth)));
  };
  for (int ring = 0; ring < rings; ++ring) {
    for (int slice = 0; slice < 2 * rings; ++slice) {
      if (ring + 1 < rings) {
        addTriangle(scene, at(ring, slice), at(ring + 1, slice), at(ring + 1, slice + 1), material);
      }
      if (ring > 0) {
        addTriangle(scene, at(ring, slice), at(ring + 1, slice + 1), at(ring, slice + 1), material);
      }
    }
  }
}

Scene worldM1() {
  Scene scene = emptyWorld();
  addFloor(scene, 2, -8);
  addWall(scene, 8, 7);
  return scene;
}

Scene worldM2() {
  Scene scene = emptyWorld();
  addFloor(scene, 12, -4);
  addWall(scene, 4, 3);
  return scene;
}

Scene worldM3() {
  Scene scene = worldM1();
  Material both_sides;
  both_sides.double_sided = true;
  const int quad = addMaterial(scene, both_sides);
  addQuad(scene, {-1, -0.2F, -4}, {1, -0.2F, -4}, {1, 0.6F, -4}, {-1, 0.6F, -4}, quad);
  return scene;
}

Scene worldM4() {
  Scene scene = emptyWorld();
  addFloor(scene, 2, -10);
  addQuad(scene, {1, -1, -10}, {1, -1, -2}, {1, 3, -2}, {1, 3, -10});
  addQuad(scene, {-1, -1, -3}, {0.75F, -1, -4.75F}, {0.75F, 1, -4.75F}, {-1, 1, -3});
  addWall(scene, 10, 5);
  return scene;
}

TrueSurfaces surfacesOf(const Scene& scene) {
  Expected<TrueSurfaces> surfaces = TrueSurfaces::build(scene, glm::dmat4(1.0));
  if (!surfaces) {
    ADD_FAILURE() << sentence(surfaces.error());
    std::abort();
  }
  return *std::move(surfaces);
}

GeometryResult traceWorld(const AnalyticScene& gbuffer, const Scene& world, const TraceParameters& parameters,
                          int thread_count) {
  const TrueSurfaces surfaces = surfacesOf(world);
  Expected<GeometryResult> result = traceGeometry(gbuffer.input(parameters), surfaces, thread_count);
  if (!result) {
    ADD_FAILURE() << sentence(result.error());
    return {};
  }
  return *std::move(result);
}

std::optional<LoopHit> loopOverTriangles(const Scene& scene, glm::dvec3 origin, glm::dvec3 dir,
                                         double min_t_m) {
  std::optional<LoopHit> nearest;
  for (std::size_t i = 0; i + 2 < scene.vertices.size(); i += 3) {
    const glm::dvec3 a(scene.vertices[i].p_world);
    const glm::dvec3 edge1 = glm::dvec3(scene.vertices[i + 1].p_world) - a;
    const glm::dvec3 edge2 = glm::dvec3(scene.vertices[i + 2].p_world) - a;
    const glm::dvec3 p = glm::cross(dir, edge2);
    const double determinant = glm::dot(edge1, p);  // positive: the ray meets the front
    const Material& material = scene.materials[static_cast<std::size_t>(scene.vertices[i].material_index)];
    if (determinant == 0.0 || (determinant < 0.0 && !material.double_sided)) {
      continue;
    }
    const glm::dvec3 from_a = origin - a;
    const glm::dvec3 q = glm::cross(from_a, edge1);
    const double u = glm::dot(from_a, p) / determinant;
    const double v = glm::dot(dir, q) / determinant;
    const double t_m = glm::dot(edge2, q) / determinant;
    const double inside = std::min({u, v, 1.0 - u - v});
    if (inside >= 0.0 && t_m >= min_t_m && (!nearest || t_m < nearest->t_m)) {
      nearest = LoopHit{t_m, static_cast<std::uint32_t>(i / 3), inside};
    }
  }
  return nearest;
}

std::vector<TrueRay> raysOf(const GeometryResult& result) {
  std::vector<TrueRay> rays;
  for (std::size_t pixel = 0; pixel < result.pixelCount(); ++pixel) {
    rays.push_back(result.at(pixel));
  }
  return rays;
}

std::map<TrueClass, int> countClasses(const GeometryResult& result) {
  std::map<TrueClass, int> counts;
  for (const TrueRay& ray : raysOf(result)) {
    ++counts[ray.true_class];
  }
  return counts;
}

glm::dvec2 ndcOf(Size size, int x, int y) {
  return {2.0 * (x + 0.5) / size.width - 1.0, 1.0 - 2.0 * (y + 0.5) / size.height};
}
glm::dvec3 wayOf(Size size, int x, int y) {
  const glm::dvec2 ndc = ndcOf(size, x, y);
  return {0.5 * ndc.x * size.width / size.height, 0.5 * ndc.y, -1.0};
}
glm::dvec2 pxOf(Size size, glm::dvec3 p_view) {
  return {size.width * 0.5 + size.height * p_view.x / -p_view.z, size.height * (0.5 - p_view.y / -p_view.z)};
}

AnalyticScene mirrorFloor(Size size) {
  return render(formulaCamera(size), {{.normal_view = {0.0, 1.0, 0.0}, .offset = -1.0, .is_mirror = true}});
}

}  // namespace ssrkit::testing
