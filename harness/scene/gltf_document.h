#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/error.h"
#include "scene/gltf_source.h"

namespace tinygltf {
class Model;
}

namespace ssrkit {

// Where an image's encoded bytes are: a URI, or a buffer view when the URI is empty.
struct GltfImageSource {
  std::string uri;
  int buffer_view = -1;
};

// One animation as the file has it: indices and words, checked by gltf_animations.h.
struct GltfAnimation {
  struct Sampler {
    int input = 0;  // accessors
    int output = 0;
    std::string interpolation;
  };
  struct Channel {
    int sampler = 0;
    int node = -1;  // -1: none given
    std::string path;
  };
  std::vector<Sampler> samplers;
  std::vector<Channel> channels;
};

// What was left out or mended while a scene was built; each count becomes one note.
struct GltfTally {
  std::size_t non_triangle_primitives = 0;
  std::size_t incomplete_triangles = 0;
  std::size_t degenerate_triangles = 0;
  std::size_t mended_normals = 0;
  std::size_t mended_uvs = 0;
  std::size_t skinned_nodes = 0;
  std::size_t unread_channels = 0;
  std::size_t rival_channels = 0;
  std::size_t morphed_primitives = 0;
  std::size_t coloured_primitives = 0;
  std::size_t mixed_uv_materials = 0;
  std::size_t unread_textures = 0;
};

// A glTF document whose structure has been checked: every index in `model` points at something. The model
// holds no buffers and no images; their bytes are here, and every access to them is checked where it is made.
struct GltfDocument {
  GltfSource source;
  std::shared_ptr<const tinygltf::Model> model;
  std::vector<std::vector<std::uint8_t>> buffers;
  std::vector<GltfImageSource> images;
  std::vector<GltfAnimation> animations;
  std::vector<std::string> notes;
  GltfTally tally;
};

[[nodiscard]] Expected<GltfDocument> readGltfDocument(const GltfSource& source);

// The tally as sentences.
[[nodiscard]] std::vector<std::string> notesOf(const GltfTally& tally);

}  // namespace ssrkit
