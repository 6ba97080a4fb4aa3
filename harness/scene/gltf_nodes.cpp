#include "scene/gltf_nodes.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <glm/gtc/quaternion.hpp>

#include "scene/clean_name.h"

namespace ssrkit {

namespace {

SceneNode sceneNode(const tinygltf::Node& from, int file_node, int parent) {
  SceneNode node;
  node.file_node = file_node;
  node.parent = parent;
  if (from.matrix.size() == 16) {
    glm::dmat4& matrix = node.matrix.emplace(1.0);
    for (int i = 0; i < 16; ++i) {
      matrix[i / 4][i % 4] = from.matrix[static_cast<std::size_t>(i)];
    }
    return node;
  }
  if (from.translation.size() == 3) {
    node.translation = {from.translation[0], from.translation[1], from.translation[2]};
  }
  if (from.rotation.size() == 4) {
    const glm::dquat rotation(from.rotation[3], from.rotation[0], from.rotation[1], from.rotation[2]);
    node.rotation = glm::dot(rotation, rotation) > 0.0 ? glm::normalize(rotation) : node.rotation;
  }
  if (from.scale.size() == 3) {
    node.scale = {from.scale[0], from.scale[1], from.scale[2]};
  }
  return node;
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

Expected<NodeTree> readNodes(GltfDocument& document) {
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
  struct Open {
    int file_node;
    int parent;
  };
  std::vector<Open> open;
  for (auto root = roots->rbegin(); root != roots->rend(); ++root) {
    open.push_back({*root, -1});
  }
  NodeTree tree{.source = document.source, .nodes = {}, .places = {}, .channels = {}};
  while (!open.empty()) {
    const Open current = open.back();
    open.pop_back();
    const auto file_node = static_cast<std::size_t>(current.file_node);
    const auto tree_node = static_cast<int>(tree.nodes.size());
    tree.nodes.push_back(sceneNode(model.nodes[file_node], current.file_node, current.parent));
    tree.places.push_back(placeOf(model, file_node));
    const std::vector<int>& children = model.nodes[file_node].children;
    for (auto child = children.rbegin(); child != children.rend(); ++child) {
      open.push_back({*child, tree_node});
    }
  }
  return tree;
}

Expected<std::vector<PlacedNode>> placeNodes(const NodeTree& tree, double time_s) {
  const auto places = worldFromNodes(tree, time_s);
  if (!places) {
    return tl::make_unexpected(places.error());
  }
  std::vector<PlacedNode> placed;
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    placed.push_back({tree.nodes[i].file_node, tree.nodes[i].moves ? static_cast<int>(i) : -1, (*places)[i]});
  }
  return placed;
}

}  // namespace ssrkit
