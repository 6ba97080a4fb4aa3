// The nodes of a scene with their animation: where each is in the world at a time.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "scene/animation.h"
#include "scene/gltf_source.h"

namespace ssrkit {

struct SceneNode {
  int file_node = 0;                 // index in the file
  int parent = -1;                   // index in the tree, smaller than this node's own; -1: a root
  bool moves = false;                // it or a node above it is animated
  std::optional<glm::dmat4> matrix;  // in the place of the three below
  glm::dvec3 translation{0.0};
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};  // unit
  glm::dvec3 scale{1.0};
};

enum class AnimatedPath { kTranslation, kRotation, kScale };

struct NodeChannel {
  int node = 0;  // index in the tree
  AnimatedPath path = AnimatedPath::kTranslation;
  AnimationCurve curve;
};

struct NodeTree {
  GltfSource source;  // for messages
  std::vector<SceneNode> nodes;
  std::vector<std::string> places;    // of each node, for messages: "nodes[3] 'lid'"
  std::vector<NodeChannel> channels;  // at most one for each path of a node
};

// World from node, of each node. Fails on a transform that is not finite.
[[nodiscard]] Expected<std::vector<glm::dmat4>> worldFromNodes(const NodeTree& tree, double time_s);

// The rigid part of a camera node's place, inverted: tracing needs lengths and angles as they are in the
// world. Nothing where the place has no direction left.
[[nodiscard]] std::optional<glm::dmat4> viewFromWorld(const glm::dmat4& world_from_node);

// Where a node's -z points, unit; straight down where it points nowhere.
[[nodiscard]] glm::dvec3 aheadOf(const glm::dmat4& world_from_node);

}  // namespace ssrkit
