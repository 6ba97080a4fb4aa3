#include "scene/gltf_document.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "base/text.h"
#include "scene/clean_name.h"
#include "scene/gltf_container.h"
#include "scene/gltf_json.h"
#include "scene/gltf_schema.h"
#include "scene/gltf_uri.h"

namespace ssrkit {

namespace {

using nlohmann::json;

constexpr std::size_t kMaxBufferBytes = std::size_t{2} << 30;  // all together

Expected<std::vector<std::uint8_t>> readBuffer(const GltfSource& source, const json& buffer,
                                               GltfContainer& container, std::size_t index) {
  const std::string place = fmt::format("buffers[{}]", index);
  const auto declared = buffer.at("byteLength").get<std::size_t>();
  Expected<std::vector<std::uint8_t>> bytes;
  if (buffer.contains("uri")) {
    bytes = readGltfUri(source, buffer.at("uri").get_ref<const std::string&>(), place + ".uri");
  } else if (index == 0 && container.has_binary) {
    bytes = std::move(container.binary);
  } else {
    return source.refuse(place, "it has neither a URI nor a binary chunk");
  }
  if (bytes && bytes->size() < declared) {
    return source.refuse(place, fmt::format("it declares {} bytes and has {}", declared, bytes->size()),
                         "the file was cut short; copy it again");
  }
  return bytes;
}

Expected<void> readBuffers(GltfDocument& document, const json& root, GltfContainer& container) {
  std::size_t total_bytes = 0;
  for (const json& buffer : root.value("buffers", json::array())) {
    auto bytes = readBuffer(document.source, buffer, container, document.buffers.size());
    if (!bytes) {
      return tl::make_unexpected(bytes.error());
    }
    total_bytes += bytes->size();
    if (total_bytes > kMaxBufferBytes) {
      return document.source.refuse("buffers", "they hold more than 2 GiB");
    }
    document.buffers.push_back(*std::move(bytes));
  }
  return {};
}

Expected<void> collectImages(GltfDocument& document, const json& root) {
  for (const json& image : root.value("images", json::array())) {
    const GltfImageSource found{image.value("uri", std::string()), image.value("bufferView", -1)};
    if (found.uri.empty() == (found.buffer_view < 0)) {
      return document.source.refuse(fmt::format("images[{}]", document.images.size()),
                                    "it must have either a URI or a buffer view");
    }
    document.images.push_back(found);
  }
  return {};
}

// Straight from the JSON, whose types the schema has checked: tinygltf copies an animation's `extras` too.
std::vector<GltfAnimation> collectAnimations(const json& root) {
  std::vector<GltfAnimation> animations;
  for (const json& from : root.value("animations", json::array())) {
    GltfAnimation animation;
    for (const json& sampler : from.at("samplers")) {
      animation.samplers.push_back({sampler.at("input").get<int>(), sampler.at("output").get<int>(),
                                    sampler.value("interpolation", std::string("LINEAR"))});
    }
    for (const json& channel : from.at("channels")) {
      const json& target = channel.at("target");
      animation.channels.push_back(
          {channel.at("sampler").get<int>(), target.value("node", -1), target.at("path").get<std::string>()});
    }
    animations.push_back(std::move(animation));
  }
  return animations;
}

// What tinygltf is given: the structure only. It follows URIs, decodes images and copies `extras` of any
// depth by rules of its own, so none of those reach it.
std::string structureOnly(json& root) {
  for (const char* member : {"buffers", "images", "animations", "skins", "extras", "extensionsRequired"}) {
    root.erase(member);
  }
  return root.dump();
}

Expected<std::shared_ptr<const tinygltf::Model>> parseModel(const GltfSource& source,
                                                            const std::string& text) {
  auto model = std::make_shared<tinygltf::Model>();
  tinygltf::TinyGLTF parser;
  std::string error;
  std::string warning;
  if (text.size() > std::numeric_limits<unsigned>::max()) {
    return source.refuse("", "its JSON is larger than 4 GiB");
  }
  try {
    if (parser.LoadASCIIFromString(model.get(), &error, &warning, text.data(),
                                   static_cast<unsigned>(text.size()), "")) {
      return model;
    }
  } catch (const std::exception& exception) {
    error = exception.what();
  }
  return source.refuse("", "tinygltf says: " + cleanName(error));
}

void noteIgnoredExtensions(GltfDocument& document) {
  std::vector<std::string> ignored;
  for (const std::string& name : document.model->extensionsUsed) {
    if (!isReadExtension(name)) {
      ignored.push_back(cleanName(name));
    }
  }
  if (!ignored.empty()) {
    document.notes.push_back(fmt::format("What the file says by {} is left out.", joinNames(ignored)));
  }
}

}  // namespace

Expected<GltfDocument> readGltfDocument(const GltfSource& source) {
  auto container = readGltfContainer(source);
  if (!container) {
    return tl::make_unexpected(container.error());
  }
  auto root = parseGltfJson(source, container->json_text);
  if (!root) {
    return tl::make_unexpected(root.error());
  }
  container->json_text = {};
  if (auto schema = checkGltfSchema(source, *root); !schema) {
    return tl::make_unexpected(schema.error());
  }
  GltfDocument document;
  document.source = source;
  if (auto buffers = readBuffers(document, *root, *container); !buffers) {
    return tl::make_unexpected(buffers.error());
  }
  if (auto images = collectImages(document, *root); !images) {
    return tl::make_unexpected(images.error());
  }
  document.animations = collectAnimations(*root);
  auto model = parseModel(source, structureOnly(*root));
  if (!model) {
    return tl::make_unexpected(model.error());
  }
  document.model = *std::move(model);
  noteIgnoredExtensions(document);
  return document;
}

std::vector<std::string> notesOf(const GltfTally& tally) {
  std::vector<std::string> notes;
  const auto add = [&notes](std::size_t count, std::string_view one, std::string_view many,
                            std::string_view what) {
    if (count > 0) {
      notes.push_back(fmt::format("{} {} {}.", count, count == 1 ? one : many, what));
    }
  };
  add(tally.non_triangle_primitives, "primitive", "primitives", "of points or lines left out");
  add(tally.incomplete_triangles, "triangle", "triangles", "without a third corner left out");
  add(tally.degenerate_triangles, "triangle", "triangles", "without area left out");
  add(tally.mended_normals, "normal", "normals", "of no length replaced by the face's own");
  add(tally.mended_uvs, "texture coordinate", "texture coordinates", "that were not finite set to 0");
  add(tally.skinned_nodes, "skinned mesh", "skinned meshes", "drawn in the bind pose");
  add(tally.unread_channels, "animation channel", "animation channels",
      "of morph weights, or of no node, left out");
  add(tally.rival_channels, "animation channel", "animation channels",
      "left out: an earlier animation of the file moves the same property of the node");
  add(tally.morphed_primitives, "primitive", "primitives", "drawn without morph targets");
  add(tally.coloured_primitives, "primitive", "primitives", "drawn without vertex colours");
  add(tally.mixed_uv_materials, "texture", "textures",
      "drawn with the texture coordinates of the material's first one");
  add(tally.unread_textures, "texture", "textures", "without a PNG or JPEG image left out");
  return notes;
}

}  // namespace ssrkit
