#include "scene/gltf_nodes.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "scene/clean_name.h"

namespace ssrkit {

namespace {

glm::dmat4 transformOf(const tinygltf::Node& node) {
  glm::dmat4 matrix(1.0);
  if (node.matrix.size() == 16) {
    for (int i = 0; i < 16; ++i) {
      matrix[i / 4][i % 4] = node.matrix[static_cast<std::size_t>(i)];
    }
    return matrix;
  }
  if (node.translation.size() == 3) {
    matrix = glm::translate(matrix, {node.translation[0], node.translation[1], node.translation[2]});
  }
  if (node.rotation.size() == 4) {
    const glm::dquat rotation(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
    matrix *= glm::dot(rotation, rotation) > 0.0 ? glm::mat4_cast(glm::normalize(rotation)) : glm::dmat4(1.0);
  }
  if (node.scale.size() == 3) {
    matrix = glm::scale(matrix, {node.scale[0], node.scale[1], node.scale[2]});
  }
  return matrix;
}

bool isFinite(const glm::dmat4& matrix) {
  for (int i = 0; i < 16; ++i) {
    if (!std::isfinite(matrix[i / 4][i % 4])) {
      return false;
    }
  }
  return true;
}

std::string placeOf(const tinygltf::Model& model, std::size_t node) {
  const std::string name = cleanName(model.nodes[node].name);
  return name.empty() ? fmt::format("nodes[{}]", node) : fmt::format("nodes[{}] '{}'", node, name);
}

// The parent of each node, -1 for roots.
Expected<std::vector<int>> parentsOf(const GltfDocument& document) {
  const tinygltf::Model& model = *document.model;
  std::vector<int> parents(model.nodes.size(), -1);
  for (std::size_t node = 0; node < model.nodes.size(); ++node) {
    for (const int child : model.nodes[node].children) {
      int& parent = parents[static_cast<std::size_t>(child)];
      if (parent >= 0) {
        return document.source.refuse(
            placeOf(model, static_cast<std::size_t>(child)),
            fmt::format("it is a child of nodes[{}] and of nodes[{}]", parent, node));
      }
      parent = static_cast<int>(node);
    }
  }
  return parents;
}

// With one parent each, what no root leads to is a cycle.
Expected<void> refuseCycles(const GltfDocument& document, const std::vector<int>& parents) {
  const tinygltf::Model& model = *document.model;
  std::vector<bool> reached(parents.size(), false);
  std::vector<int> open;
  for (std::size_t node = 0; node < parents.size(); ++node) {
    if (parents[node] < 0) {
      open.push_back(static_cast<int>(node));
    }
  }
  while (!open.empty()) {
    const auto node = static_cast<std::size_t>(open.back());
    open.pop_back();
    reached[node] = true;
    open.insert(open.end(), model.nodes[node].children.begin(), model.nodes[node].children.end());
  }
  for (std::size_t node = 0; node < parents.size(); ++node) {
    if (!reached[node]) {
      return document.source.refuse(placeOf(model, node), "it is its own ancestor");
    }
  }
  return {};
}

Expected<std::vector<int>> rootsOf(GltfDocument& document, const std::vector<int>& parents) {
  const tinygltf::Model& model = *document.model;
  std::vector<int> roots;
  if (model.scenes.empty()) {
    for (std::size_t node = 0; node < parents.size(); ++node) {
      if (parents[node] < 0) {
        roots.push_back(static_cast<int>(node));
      }
    }
    return roots;
  }
  const int scene = std::max(model.defaultScene, 0);
  if (model.scenes.size() > 1) {
    document.notes.push_back(
        fmt::format("Of the file's {} scenes the one numbered {} is drawn.", model.scenes.size(), scene));
  }
  std::vector<bool> listed(parents.size(), false);
  for (const int root : model.scenes[static_cast<std::size_t>(scene)].nodes) {
    const auto node = static_cast<std::size_t>(root);
    if (parents[node] >= 0 || listed[node]) {
      return document.source.refuse(
          fmt::format("scenes[{}].nodes", scene),
          fmt::format("{} is {}", placeOf(model, node), listed[node] ? "listed twice" : "no root"));
    }
    listed[node] = true;
    roots.push_back(root);
  }
  return roots;
}

}  // namespace

Expected<std::vector<PlacedNode>> placeNodes(GltfDocument& document) {
  const auto parents = parentsOf(document);
  if (!parents) {
    return tl::make_unexpected(parents.error());
  }
  if (auto acyclic = refuseCycles(document, *parents); !acyclic) {
    return tl::make_unexpected(acyclic.error());
  }
  const auto roots = rootsOf(document, *parents);
  if (!roots) {
    return tl::make_unexpected(roots.error());
  }
  const tinygltf::Model& model = *document.model;
  std::vector<PlacedNode> open;
  for (auto root = roots->rbegin(); root != roots->rend(); ++root) {
    open.push_back({*root, glm::dmat4(1.0)});
  }
  std::vector<PlacedNode> placed;
  while (!open.empty()) {
    PlacedNode current = open.back();
    open.pop_back();
    const auto node = static_cast<std::size_t>(current.node);
    current.world_from_node *= transformOf(model.nodes[node]);
    if (!isFinite(current.world_from_node)) {
      return document.source.refuse(placeOf(model, node), "its transform is not finite");
    }
    placed.push_back(current);
    const std::vector<int>& children = model.nodes[node].children;
    for (auto child = children.rbegin(); child != children.rend(); ++child) {
      open.push_back({*child, current.world_from_node});
    }
  }
  return placed;
}

}  // namespace ssrkit
