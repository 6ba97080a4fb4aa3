// Scenes of a few triangles made by hand, and a second way to find what a ray meets in them: a loop over all
// triangles in double precision, without Embree.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <vector>

#include "analytic_scene.h"
#include "oracle/geometry.h"
#include "oracle/true_surfaces.h"
#include "scene/scene.h"

namespace ssrkit::testing {

// One material, opaque and single-sided, and no triangle yet. World space is view space in these tests.
[[nodiscard]] Scene emptyWorld();

// Another material; returns its index.
int addMaterial(Scene& scene, const Material& material);

// Corners counter-clockwise as seen from the front.
void addTriangle(Scene& scene, glm::vec3 a, glm::vec3 b, glm::vec3 c, int material = 0);
// Two triangles; texture coordinates (0, 0) to (1, 1) from a to c.
void addQuad(Scene& scene, glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d, int material = 0);
// Of rings x 2 rings faces, outside in front.
void addSphere(Scene& scene, glm::dvec3 centre, double radius_m, int rings, int material = 0);

// The triangles of the closed forms' scenes, where analytic_scene.h has their planes.
[[nodiscard]] Scene worldM1();
[[nodiscard]] Scene worldM2();
[[nodiscard]] Scene worldM3();
[[nodiscard]] Scene worldM4();

[[nodiscard]] TrueSurfaces surfacesOf(const Scene& scene);

// The whole of Oracle B over a G-buffer and a world.
[[nodiscard]] GeometryResult traceWorld(const AnalyticScene& gbuffer, const Scene& world,
                                        const TraceParameters& parameters = {}, int thread_count = 2);

// The nearest triangle in front of `min_t_m` whose drawn side the ray meets, by Moeller and Trumbore's test.
struct LoopHit {
  double t_m = 0.0;
  std::uint32_t triangle = 0;
  double edge_distance = 0.0;  // the least barycentric coordinate: how far inside the triangle
};
[[nodiscard]] std::optional<LoopHit> loopOverTriangles(const Scene& scene, glm::dvec3 origin, glm::dvec3 dir,
                                                       double min_t_m = 0.0);

// The direction through a texel's centre at dist_view 1, where it lies in NDC, and where a point is seen,
// with the closed forms' camera: f = 2.
[[nodiscard]] glm::dvec2 ndcOf(Size size, int x, int y);
[[nodiscard]] glm::dvec3 wayOf(Size size, int x, int y);
[[nodiscard]] glm::dvec2 pxOf(Size size, glm::dvec3 p_view);

// A mirror floor one metre down that fills the lower half of the image, nothing else in the G-buffer.
[[nodiscard]] AnalyticScene mirrorFloor(Size size);

// One for each pixel, row by row from the upper left.
[[nodiscard]] std::vector<TrueRay> raysOf(const GeometryResult& result);
[[nodiscard]] std::map<TrueClass, int> countClasses(const GeometryResult& result);

// Sizes square, wide, odd, high and tiny.
inline constexpr std::array<Size, 5> kWorldSizes = {{{256, 256}, {160, 90}, {127, 63}, {33, 97}, {5, 7}}};

}  // namespace ssrkit::testing
