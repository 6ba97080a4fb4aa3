#include "scene/node_tree.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace ssrkit {

namespace {

glm::dmat4 transformOf(const SceneNode& node) {
  if (node.matrix) {
    return *node.matrix;
  }
  const glm::dmat4 placed = glm::translate(glm::dmat4(1.0), node.translation);
  return glm::scale(placed * glm::mat4_cast(node.rotation), node.scale);
}

bool isFinite(const glm::dmat4& matrix) {
  for (int i = 0; i < 16; ++i) {
    if (!std::isfinite(matrix[i / 4][i % 4])) {
      return false;
    }
  }
  return true;
}

// The nodes as their animation has them.
std::vector<SceneNode> nodesAt(const NodeTree& tree, double time_s) {
  std::vector<SceneNode> nodes = tree.nodes;
  for (const NodeChannel& channel : tree.channels) {
    SceneNode& node = nodes[static_cast<std::size_t>(channel.node)];
    switch (channel.path) {
      case AnimatedPath::kTranslation:
        node.translation = vectorAt(channel.curve, time_s);
        break;
      case AnimatedPath::kRotation:
        node.rotation = rotationAt(channel.curve, time_s);
        break;
      case AnimatedPath::kScale:
        node.scale = vectorAt(channel.curve, time_s);
        break;
    }
  }
  return nodes;
}

}  // namespace

Expected<std::vector<glm::dmat4>> worldFromNodes(const NodeTree& tree, double time_s) {
  std::vector<glm::dmat4> places;
  places.reserve(tree.nodes.size());
  for (const SceneNode& node : nodesAt(tree, time_s)) {
    glm::dmat4 place = transformOf(node);
    if (node.parent >= 0) {
      place = places[static_cast<std::size_t>(node.parent)] * place;
    }
    if (!isFinite(place)) {
      return tree.source.refuse(tree.places[places.size()],
                                node.moves ? fmt::format("its transform is not finite at {} s", time_s)
                                           : "its transform is not finite");
    }
    places.push_back(place);
  }
  return places;
}

std::optional<glm::dmat4> viewFromWorld(const glm::dmat4& world_from_node) {
  const glm::dvec3 back(world_from_node[2]);
  const glm::dvec3 up(world_from_node[1]);
  const glm::dvec3 right = glm::cross(up, back);
  if (!(glm::length(right) > 1e-12 * glm::length(up) * glm::length(back))) {
    return std::nullopt;
  }
  const glm::dvec3 z = glm::normalize(back);
  const glm::dvec3 x = glm::normalize(right);
  const glm::dvec3 y = glm::cross(z, x);
  const glm::dvec3 eye(world_from_node[3]);
  glm::dmat4 view_from_world(glm::transpose(glm::dmat3(x, y, z)));
  view_from_world[3] = glm::dvec4(-glm::dot(x, eye), -glm::dot(y, eye), -glm::dot(z, eye), 1.0);
  return view_from_world;
}

glm::dvec3 aheadOf(const glm::dmat4& world_from_node) {
  const glm::dvec3 ahead = -glm::dvec3(world_from_node[2]);
  const double length = glm::length(ahead);
  return length > 0.0 ? ahead / length : glm::dvec3(0.0, -1.0, 0.0);
}

}  // namespace ssrkit
