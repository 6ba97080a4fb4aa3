#include "environment/octahedral.h"

#include <algorithm>
#include <cmath>

namespace ssrkit {

namespace {

float signOf(float value) {
  return value < 0.0F ? -1.0F : 1.0F;
}

glm::vec2 folded(glm::vec2 square) {
  return {(1.0F - std::abs(square.y)) * signOf(square.x), (1.0F - std::abs(square.x)) * signOf(square.y)};
}

}  // namespace

glm::vec2 octahedralFromDirection(glm::vec3 direction) {
  const float sum = std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z);
  const glm::vec2 square = glm::vec2(direction.x, direction.z) / sum;
  return direction.y < 0.0F ? folded(square) : square;
}

glm::vec3 octahedronPoint(glm::vec2 square) {
  const float y = 1.0F - std::abs(square.x) - std::abs(square.y);
  const glm::vec2 flat = y < 0.0F ? folded(square) : square;
  return {flat.x, y, flat.y};
}

glm::vec3 directionFromOctahedral(glm::vec2 square) {
  return glm::normalize(octahedronPoint(square));
}

glm::vec2 OctahedralMap::square(int x, int y, glm::vec2 in_texel) const {
  const glm::vec2 position(static_cast<float>(x - 1), static_cast<float>(y - 1));
  return (position + in_texel) * (2.0F / static_cast<float>(inner())) - 1.0F;
}

float OctahedralMap::solidAngle(int x, int y) const {
  // A face of the octahedron stands 1/sqrt(3) away and is 1/sqrt(3) of its area on the square: both cancel
  // but for the distance.
  const float step = 2.0F / static_cast<float>(inner());
  const float distance = glm::length(octahedronPoint(square(x, y)));
  return step * step / (distance * distance * distance);
}

void OctahedralMap::wrapBorder() {
  // Beyond an edge the map goes on at the mirrored place of the same edge; beyond a corner, at the opposite
  // corner.
  const int last = side - 1;
  for (int i = 1; i < last; ++i) {
    at(0, i) = at(1, last - i);
    at(last, i) = at(last - 1, last - i);
    at(i, 0) = at(last - i, 1);
    at(i, last) = at(last - i, last - 1);
  }
  at(0, 0) = at(last - 1, last - 1);
  at(last, 0) = at(1, last - 1);
  at(0, last) = at(last - 1, 1);
  at(last, last) = at(1, 1);
}

glm::vec3 OctahedralMap::sample(glm::vec3 direction) const {
  const glm::vec2 unit = 0.5F * octahedralFromDirection(direction) + 0.5F;
  const glm::vec2 position = unit * static_cast<float>(inner()) + 0.5F;
  const int x = std::clamp(static_cast<int>(position.x), 0, side - 2);
  const int y = std::clamp(static_cast<int>(position.y), 0, side - 2);
  const glm::vec2 weight = position - glm::vec2(static_cast<float>(x), static_cast<float>(y));
  const glm::vec3 upper = glm::mix(at(x, y), at(x + 1, y), weight.x);
  const glm::vec3 lower = glm::mix(at(x, y + 1), at(x + 1, y + 1), weight.x);
  return glm::mix(upper, lower, weight.y);
}

}  // namespace ssrkit
