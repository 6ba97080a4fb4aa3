// Directions on a square: the octahedral map (Meyer, Suessmuth, Sussner, Stamminger, Greiner, "On
// Floating-Point Normal Vectors", EGSR 2010, section 3; Cigolle et al., "A Survey of Efficient
// Representations for Independent Unit Vectors", JCGT 3(2) 2014), with +y in the middle and -y in the four
// corners.
//
// It is chosen over the equirectangular layout because it has no poles: the solid angle of a texel varies by
// a factor of 5.2 only, instead of without limit, and one row and column of border texels makes plain
// bilinear filtering right across every edge, at every mip, on hardware that knows no cube maps in this kit's
// device.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace ssrkit {

// A unit direction to the square [-1, 1]^2 and back (the result is not normalised: it lies on the
// octahedron).
[[nodiscard]] glm::vec2 octahedralFromDirection(glm::vec3 direction);
[[nodiscard]] glm::vec3 octahedronPoint(glm::vec2 square);
[[nodiscard]] glm::vec3 directionFromOctahedral(glm::vec2 square);

// A square map of `side` texels a side, of which the outermost are a border that repeats the texels on the
// other side of each edge: `side` - 2 texels a side hold directions.
struct OctahedralMap {
  int side = 0;
  std::vector<glm::vec3> texels;  // side * side, row 0 first

  OctahedralMap() = default;
  explicit OctahedralMap(int map_side)
      : side(map_side), texels(static_cast<std::size_t>(map_side) * static_cast<std::size_t>(map_side)) {}

  [[nodiscard]] glm::vec3& at(int x, int y) { return texels[index(x, y)]; }
  [[nodiscard]] const glm::vec3& at(int x, int y) const { return texels[index(x, y)]; }
  [[nodiscard]] int inner() const { return side - 2; }

  // The position on the square of a point of the texel (x, y), borders counted; (0.5, 0.5) is its centre.
  [[nodiscard]] glm::vec2 square(int x, int y, glm::vec2 in_texel = glm::vec2(0.5F)) const;
  // Solid angle of a texel, by its centre.
  [[nodiscard]] float solidAngle(int x, int y) const;

  // Fills the border from the texels inside.
  void wrapBorder();

  // Bilinear; right across all edges once the border is filled.
  [[nodiscard]] glm::vec3 sample(glm::vec3 direction) const;

 private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x);
  }
};

}  // namespace ssrkit
