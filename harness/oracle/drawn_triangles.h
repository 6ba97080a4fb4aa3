// The scene's triangles in the view space of a camera, and which of their points a rasteriser would draw.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "oracle/true_surfaces.h"
#include "scene/scene.h"

namespace ssrkit {

class DrawnTriangles {
 public:
  DrawnTriangles(const Scene& scene, const glm::dmat4& view_from_world);

  [[nodiscard]] std::size_t count() const { return material_indices_.size(); }
  [[nodiscard]] const glm::dmat4& viewFromWorld() const { return view_from_world_; }
  // In view space.
  [[nodiscard]] std::array<glm::dvec3, 3> corners(std::size_t triangle) const;

  // Whether a ray in this direction finds the triangle drawn at the barycentric coordinates u, v of its
  // second and third corner: on that side, and not cut out. `face_normal` points to its front, of any length.
  [[nodiscard]] bool isThere(std::size_t triangle, const glm::dvec3& face_normal, const glm::dvec3& dir_view,
                             float u, float v) const;

  // Whether the ray leaves this very surface, see TrueSurfaces::firstHit. `face_normal` is unit.
  [[nodiscard]] bool isLeftBy(const SurfaceRay& ray, const std::array<glm::dvec3, 3>& corner,
                              const glm::dvec3& face_normal) const;

 private:
  struct Look {
    bool is_double_sided = false;
    bool is_cut_out = false;  // its alpha decides point by point
  };

  glm::dmat4 view_from_world_;
  std::vector<glm::vec3> p_world_;     // three a triangle
  std::vector<glm::vec2> uvs_;         // likewise; empty where nothing is cut out
  std::vector<int> material_indices_;  // one a triangle
  std::vector<Look> looks_;            // one a material
  Scene cut_outs_;                     // materials and textures alone
};

}  // namespace ssrkit
