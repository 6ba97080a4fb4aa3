// Scenes of a few quads, built by hand: what the tests of geometry passes draw.
#pragma once

#include <glm/glm.hpp>

#include "scene/scene.h"

namespace ssrkit {

// Counter-clockwise corners as seen from its outside.
struct Quad {
  glm::dvec3 a, b, c, d;
};

class PlaneScene {
 public:
  explicit PlaneScene(const glm::dvec3& light_direction);

  // A material of its own for each call; the quad's normal is its face's unless one is given.
  PlaneScene& quad(const Quad& quad, const Material& material = {});
  PlaneScene& triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                       const glm::dvec3& normal, const Material& material = {});
  // Six outward quads.
  PlaneScene& box(const glm::dvec3& least, const glm::dvec3& greatest);
  // A level floor from -extent_m to extent_m.
  PlaneScene& floor(double y, double extent_m);

  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] Scene& scene() { return scene_; }

 private:
  void addTriangle(const std::array<glm::dvec3, 3>& corners, const std::array<glm::dvec3, 3>& normals);
  void beginRange(const Material& material);
  Scene scene_;

  friend PlaneScene faceted(const glm::dvec3& light_direction, const glm::dvec3& centre, double radius_m);
};

// A sphere of 48 x 24 facets with smooth normals.
[[nodiscard]] PlaneScene faceted(const glm::dvec3& light_direction, const glm::dvec3& centre,
                                 double radius_m);

}  // namespace ssrkit
