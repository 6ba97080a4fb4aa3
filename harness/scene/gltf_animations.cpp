#include "scene/gltf_animations.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include "base/text.h"
#include "scene/clean_name.h"
#include "scene/gltf_accessor.h"

namespace ssrkit {

namespace {

struct PathRow {
  std::string_view name;
  AnimatedPath path;
  int components;
};
constexpr auto kPaths = std::to_array<PathRow>({{"translation", AnimatedPath::kTranslation, 3},
                                                {"rotation", AnimatedPath::kRotation, 4},
                                                {"scale", AnimatedPath::kScale, 3}});

struct InterpolationRow {
  std::string_view name;
  Interpolation interpolation;
};
constexpr auto kInterpolations =
    std::to_array<InterpolationRow>({{"STEP", Interpolation::kStep},
                                     {"LINEAR", Interpolation::kLinear},
                                     {"CUBICSPLINE", Interpolation::kCubicSpline}});

// A word of the file found in a table of rows with names.
template <class Rows>
Expected<const typename Rows::value_type*> findWord(const GltfDocument& document, const Rows& rows,
                                                    const std::string& word, const std::string& place) {
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const auto& r) { return r.name == word; });
  if (row != rows.end()) {
    return &*row;
  }
  std::vector<std::string> names;
  names.reserve(rows.size());
  for (const auto& r : rows) {
    names.emplace_back(r.name);
  }
  return document.source.refuse(place, fmt::format("it is '{}'", cleanName(word)),
                                "it must be one of " + joinNames(names));
}

Expected<std::vector<double>> readTimes(const GltfDocument& document, int accessor,
                                        const std::string& place) {
  const auto times = readFloats(document, accessor, 1, place);
  if (!times) {
    return tl::make_unexpected(times.error());
  }
  if (times->empty()) {
    return document.source.refuse(place, "there is no key", "give the sampler at least one time");
  }
  for (std::size_t i = 0; i < times->size(); ++i) {
    const float time = (*times)[i];
    if (!std::isfinite(time)) {
      return document.source.refuse(place, fmt::format("time {} is {}", i, time), "times must be finite");
    }
    if (i > 0 && !(time > (*times)[i - 1])) {
      return document.source.refuse(
          place, fmt::format("time {} is {} s and the one before it is {} s", i, time, (*times)[i - 1]),
          "times must increase");
    }
  }
  return std::vector<double>(times->begin(), times->end());
}

// The values, in place of whose rotations unit quaternions come back (tangents stay as they are).
Expected<std::vector<glm::dvec4>> readValues(const GltfDocument& document, int accessor, const PathRow& path,
                                             bool is_spline, const std::string& place) {
  const auto numbers = readFloats(document, accessor, path.components, place);
  if (!numbers) {
    return tl::make_unexpected(numbers.error());
  }
  const auto components = static_cast<std::size_t>(path.components);
  std::vector<glm::dvec4> values(numbers->size() / components, glm::dvec4(0.0));
  for (std::size_t i = 0; i < numbers->size(); ++i) {
    if (!std::isfinite((*numbers)[i])) {
      return document.source.refuse(place, fmt::format("value {} is not finite", i / components));
    }
    values[i / components][static_cast<int>(i % components)] = (*numbers)[i];
  }
  for (std::size_t i = is_spline ? 1 : 0; i < values.size() && path.path == AnimatedPath::kRotation;
       i += is_spline ? 3 : 1) {
    const double length = glm::length(values[i]);
    if (!(length > 0.0)) {
      return document.source.refuse(place, fmt::format("value {} is a quaternion of length 0", i),
                                    "rotations must be unit quaternions");
    }
    values[i] /= length;
  }
  return values;
}

Expected<AnimationCurve> readCurve(const GltfDocument& document, const GltfAnimation::Sampler& sampler,
                                   const PathRow& path, const std::string& place) {
  AnimationCurve curve;
  const auto interpolation =
      findWord(document, kInterpolations, sampler.interpolation, place + ".interpolation");
  if (!interpolation) {
    return tl::make_unexpected(interpolation.error());
  }
  curve.interpolation = (*interpolation)->interpolation;
  auto times = readTimes(document, sampler.input, place + ".input");
  if (!times) {
    return tl::make_unexpected(times.error());
  }
  curve.times_s = *std::move(times);
  const bool is_spline = curve.interpolation == Interpolation::kCubicSpline;
  auto values = readValues(document, sampler.output, path, is_spline, place + ".output");
  if (!values) {
    return tl::make_unexpected(values.error());
  }
  curve.values = *std::move(values);
  const std::size_t wanted = curve.times_s.size() * (is_spline ? 3 : 1);
  if (curve.values.size() != wanted) {
    return document.source.refuse(
        place, fmt::format("it has {} times and {} values", curve.times_s.size(), curve.values.size()),
        fmt::format("{} needs {} values{}", sampler.interpolation, wanted,
                    is_spline ? ": in-tangent, value and out-tangent for each time" : ""));
  }
  return curve;
}

class AnimationReader {
 public:
  AnimationReader(GltfDocument& document, NodeTree& tree) : document_(document), tree_(tree) {
    tree_nodes_.assign(document.model->nodes.size(), -1);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
      tree_nodes_[static_cast<std::size_t>(tree.nodes[i].file_node)] = static_cast<int>(i);
    }
  }

  Expected<void> read(const GltfAnimation& animation, const std::string& place) {
    std::set<Property> own;
    for (std::size_t i = 0; i < animation.channels.size(); ++i) {
      const std::string here = fmt::format("{}.channels[{}]", place, i);
      if (auto added = readChannel(animation, animation.channels[i], place, here, own); !added) {
        return added;
      }
    }
    moved_.merge(own);
    return {};
  }

 private:
  using Property = std::pair<int, AnimatedPath>;  // of a node of the file

  Expected<void> readChannel(const GltfAnimation& animation, const GltfAnimation::Channel& channel,
                             const std::string& animation_place, const std::string& place,
                             std::set<Property>& own) {
    const auto sampler = static_cast<std::size_t>(channel.sampler);
    if (sampler >= animation.samplers.size()) {
      return document_.source.refuse(
          place + ".sampler",
          fmt::format("the value is {} and there are {} samplers", sampler, animation.samplers.size()));
    }
    if (channel.path == "weights" || channel.node < 0) {
      ++document_.tally.unread_channels;
      return {};
    }
    const auto path = findWord(document_, kPaths, channel.path, place + ".target.path");
    if (!path) {
      return tl::make_unexpected(path.error());
    }
    auto curve = readCurve(document_, animation.samplers[sampler], **path,
                           fmt::format("{}.samplers[{}]", animation_place, sampler));
    if (!curve) {
      return tl::make_unexpected(curve.error());
    }
    key_count_ += curve->values.size();
    if (key_count_ > kMaxVertices) {
      return document_.source.refuse("animations",
                                     fmt::format("they hold more than {} values", kMaxVertices));
    }
    const Property property{channel.node, (*path)->path};
    if (!own.insert(property).second) {
      return document_.source.refuse(
          place, fmt::format("the animation moves the {} of nodes[{}] twice", channel.path, channel.node));
    }
    return add(property, *std::move(curve), place);
  }

  Expected<void> add(const Property& property, AnimationCurve curve, const std::string& place) {
    const int tree_node = tree_nodes_[static_cast<std::size_t>(property.first)];
    if (tree_node < 0) {
      return {};  // not in the scene that is drawn
    }
    SceneNode& node = tree_.nodes[static_cast<std::size_t>(tree_node)];
    if (node.matrix) {
      return document_.source.refuse(
          place,
          fmt::format("{} is animated and has a matrix", tree_.places[static_cast<std::size_t>(tree_node)]),
          "give the node a translation, rotation and scale instead");
    }
    if (moved_.count(property) > 0) {
      ++document_.tally.rival_channels;
      return {};
    }
    node.moves = true;
    tree_.channels.push_back({tree_node, property.second, std::move(curve)});
    return {};
  }

  GltfDocument& document_;
  NodeTree& tree_;
  std::vector<int> tree_nodes_;  // by index in the file, -1: not drawn
  std::size_t key_count_ = 0;
  std::set<Property> moved_;  // by earlier animations
};

}  // namespace

Expected<void> readAnimations(GltfDocument& document, NodeTree& tree) {
  AnimationReader reader(document, tree);
  for (std::size_t i = 0; i < document.animations.size(); ++i) {
    if (auto read = reader.read(document.animations[i], fmt::format("animations[{}]", i)); !read) {
      return read;
    }
  }
  for (SceneNode& node : tree.nodes) {
    node.moves = node.moves || (node.parent >= 0 && tree.nodes[static_cast<std::size_t>(node.parent)].moves);
  }
  return {};
}

}  // namespace ssrkit
