// The scene's triangles as a ray meets them, whether a camera sees them or not (Embree).
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <memory>
#include <optional>

#include "base/error.h"
#include "scene/scene.h"

namespace ssrkit {

// A ray in view space.
struct SurfaceRay {
  glm::dvec3 origin_view{0.0};
  glm::dvec3 dir_view{0.0};  // unit
  double min_t_m = 0.0;
  double max_t_m = std::numeric_limits<double>::infinity();
  // The origin is known to within the sum of these three vectors, each taken forwards or backwards; see
  // `firstHit`. All zero for rays that leave no surface.
  glm::dmat3 origin_error{0.0};
};

struct SurfaceHit {
  double t_m = 0.0;
  glm::dvec3 normal_view{0.0};  // unit, of the triangle's plane, on the side that the ray meets
  std::uint32_t triangle = 0;   // three vertices each, as in Scene::vertices
};

// Triangles are drawn as shaders/gbuffer.frag draws them: the back of a single-sided one is not there, nor is
// what its material cuts out.
class TrueSurfaces {
 public:
  // Keeps what it needs of the scene. Fails when Embree or the memory is not there.
  [[nodiscard]] static Expected<TrueSurfaces> build(const Scene& scene, const glm::dmat4& view_from_world);

  ~TrueSurfaces();
  TrueSurfaces(TrueSurfaces&&) noexcept;
  TrueSurfaces& operator=(TrueSurfaces&&) noexcept;

  // The first surface that the ray meets; the distance is computed in double precision from the triangle's
  // plane. May be called from several threads at once.
  //
  // A ray that leaves a surface starts on it only as well as the depth image tells. What the ray meets is
  // passed over as that very surface when the origin lies behind the triangle's plane, as the camera sees it,
  // by no more than `origin_error`, and the ray comes out of it on the camera's side. A wall that the ray
  // runs into is never passed over, however near.
  [[nodiscard]] std::optional<SurfaceHit> firstHit(const SurfaceRay& ray) const;

  [[nodiscard]] const glm::dmat4& viewFromWorld() const;

 private:
  struct Impl;
  explicit TrueSurfaces(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace ssrkit
