#include "scene/gltf_accessor.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

namespace ssrkit {

namespace {

// Elements in a buffer view: `count` of them from `first`, `stride_bytes` apart. All bytes are inside the
// view.
struct Elements {
  const std::uint8_t* first = nullptr;
  std::size_t count = 0;
  std::size_t stride_bytes = 0;
  int component_type = 0;
  int components = 0;
};

std::size_t componentBytes(int component_type) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      return 0;
  }
}

// Only the sizes are read from `wanted`; `first` is filled in.
Expected<Elements> elementsIn(const GltfDocument& document, int buffer_view, std::size_t offset,
                              Elements wanted, const std::string& place) {
  const std::size_t element_bytes =
      componentBytes(wanted.component_type) * static_cast<std::size_t>(wanted.components);
  if (element_bytes == 0) {
    return document.source.refuse(
        place, fmt::format("component type {} is not one of glTF's", wanted.component_type));
  }
  if (wanted.count > kMaxVertices) {
    return document.source.refuse(
        place, fmt::format("it has {} elements and the limit is {}", wanted.count, kMaxVertices));
  }
  const auto bytes = bytesOfView(document, buffer_view, place);
  if (!bytes) {
    return tl::make_unexpected(bytes.error());
  }
  const std::size_t stride = document.model->bufferViews[static_cast<std::size_t>(buffer_view)].byteStride;
  wanted.stride_bytes = stride == 0 ? element_bytes : stride;
  if (wanted.stride_bytes < element_bytes) {
    return document.source.refuse(
        place, fmt::format("bufferViews[{}] has a stride of {} bytes and an element has {}", buffer_view,
                           stride, element_bytes));
  }
  // Counts and strides are below 2^31 each, so nothing wraps in 64 bits.
  const std::size_t end =
      wanted.count == 0 ? offset : offset + (wanted.count - 1) * wanted.stride_bytes + element_bytes;
  if (end > bytes->size()) {
    return document.source.refuse(
        place, fmt::format("it reads {} bytes past bufferViews[{}]", end - bytes->size(), buffer_view));
  }
  wanted.first = bytes->data() + offset;
  return wanted;
}

template <class T>
T valueAt(const std::uint8_t* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

template <class T>
float asFloat(const std::uint8_t* bytes, bool normalised) {
  const auto value = static_cast<float>(valueAt<T>(bytes));
  if (std::is_floating_point_v<T> || !normalised) {
    return value;
  }
  return std::max(value / static_cast<float>(std::numeric_limits<T>::max()), -1.0F);
}

float componentAsFloat(const std::uint8_t* bytes, int component_type, bool normalised) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return asFloat<std::int8_t>(bytes, normalised);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return asFloat<std::uint8_t>(bytes, normalised);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return asFloat<std::int16_t>(bytes, normalised);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return asFloat<std::uint16_t>(bytes, normalised);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return asFloat<std::uint32_t>(bytes, normalised);
    default:
      return asFloat<float>(bytes, normalised);
  }
}

std::uint32_t componentAsIndex(const std::uint8_t* bytes, int component_type) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return valueAt<std::uint8_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return valueAt<std::uint16_t>(bytes);
    default:
      return valueAt<std::uint32_t>(bytes);
  }
}

bool isIndexType(int component_type) {
  return component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
         component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
         component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

void writeFloats(const Elements& elements, bool normalised, std::size_t element, float* out) {
  const std::uint8_t* bytes = elements.first + element * elements.stride_bytes;
  for (int c = 0; c < elements.components; ++c) {
    const std::size_t offset = static_cast<std::size_t>(c) * componentBytes(elements.component_type);
    out[c] = componentAsFloat(bytes + offset, elements.component_type, normalised);
  }
}

std::vector<std::uint32_t> indicesOf(const Elements& elements) {
  std::vector<std::uint32_t> indices(elements.count);
  for (std::size_t i = 0; i < elements.count; ++i) {
    indices[i] = componentAsIndex(elements.first + i * elements.stride_bytes, elements.component_type);
  }
  return indices;
}

// Puts the sparse values in their places in `values`.
Expected<void> applySparse(const GltfDocument& document, const tinygltf::Accessor& accessor, int components,
                           const std::string& place, std::vector<float>& values) {
  const auto& sparse = accessor.sparse;
  if (!isIndexType(sparse.indices.componentType)) {
    return document.source.refuse(place, "its sparse indices are not unsigned integers");
  }
  const auto count = static_cast<std::size_t>(sparse.count);
  const auto where =
      elementsIn(document, sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset),
                 {nullptr, count, 0, sparse.indices.componentType, 1}, place + " (sparse indices)");
  if (!where) {
    return tl::make_unexpected(where.error());
  }
  const auto what =
      elementsIn(document, sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset),
                 {nullptr, count, 0, accessor.componentType, components}, place + " (sparse values)");
  if (!what) {
    return tl::make_unexpected(what.error());
  }
  const std::vector<std::uint32_t> targets = indicesOf(*where);
  for (std::size_t i = 0; i < count; ++i) {
    if (targets[i] >= accessor.count) {
      return document.source.refuse(place, fmt::format("sparse index {} is {} and there are {} elements", i,
                                                       targets[i], accessor.count));
    }
    writeFloats(*what, accessor.normalized, i, &values[targets[i] * static_cast<std::size_t>(components)]);
  }
  return {};
}

}  // namespace

Expected<std::span<const std::uint8_t>> bytesOfView(const GltfDocument& document, int buffer_view,
                                                    const std::string& place) {
  const tinygltf::BufferView& view = document.model->bufferViews[static_cast<std::size_t>(buffer_view)];
  const std::vector<std::uint8_t>& buffer = document.buffers[static_cast<std::size_t>(view.buffer)];
  if (view.byteOffset > buffer.size() || view.byteLength > buffer.size() - view.byteOffset) {
    return document.source.refuse(
        place, fmt::format("bufferViews[{}] ends at byte {} and buffers[{}] has {}", buffer_view,
                           view.byteOffset + view.byteLength, view.buffer, buffer.size()));
  }
  return std::span(buffer).subspan(view.byteOffset, view.byteLength);
}

Expected<std::vector<float>> readFloats(const GltfDocument& document, int accessor_index, int components,
                                        const std::string& place) {
  const tinygltf::Accessor& accessor = document.model->accessors[static_cast<std::size_t>(accessor_index)];
  const std::string here = fmt::format("{} (accessors[{}])", place, accessor_index);
  const int wanted_type = components == 1 ? TINYGLTF_TYPE_SCALAR : components;  // tinygltf's VECn is n
  if (accessor.type != wanted_type) {
    return document.source.refuse(
        here, components == 1 ? "its type is not SCALAR" : fmt::format("its type is not VEC{}", components));
  }
  if (accessor.count > kMaxVertices) {
    return document.source.refuse(
        here, fmt::format("it has {} elements and the limit is {}", accessor.count, kMaxVertices));
  }
  std::vector<float> values(accessor.count * static_cast<std::size_t>(components), 0.0F);
  if (accessor.bufferView >= 0) {
    const auto elements = elementsIn(document, accessor.bufferView, accessor.byteOffset,
                                     {nullptr, accessor.count, 0, accessor.componentType, components}, here);
    if (!elements) {
      return tl::make_unexpected(elements.error());
    }
    for (std::size_t i = 0; i < accessor.count; ++i) {
      writeFloats(*elements, accessor.normalized, i, &values[i * static_cast<std::size_t>(components)]);
    }
  }
  if (accessor.sparse.isSparse) {
    if (auto applied = applySparse(document, accessor, components, here, values); !applied) {
      return tl::make_unexpected(applied.error());
    }
  }
  return values;
}

Expected<std::vector<std::uint32_t>> readIndices(const GltfDocument& document, int accessor_index,
                                                 std::size_t vertex_count, const std::string& place) {
  const tinygltf::Accessor& accessor = document.model->accessors[static_cast<std::size_t>(accessor_index)];
  const std::string here = fmt::format("{} (accessors[{}])", place, accessor_index);
  if (accessor.type != TINYGLTF_TYPE_SCALAR || !isIndexType(accessor.componentType)) {
    return document.source.refuse(here, "indices must be unsigned integers");
  }
  if (accessor.bufferView < 0 || accessor.sparse.isSparse) {
    return document.source.refuse(here, "indices must lie in a buffer view of their own");
  }
  const auto elements = elementsIn(document, accessor.bufferView, accessor.byteOffset,
                                   {nullptr, accessor.count, 0, accessor.componentType, 1}, here);
  if (!elements) {
    return tl::make_unexpected(elements.error());
  }
  std::vector<std::uint32_t> indices = indicesOf(*elements);
  const auto beyond =
      std::find_if(indices.begin(), indices.end(), [&](std::uint32_t i) { return i >= vertex_count; });
  if (beyond != indices.end()) {
    return document.source.refuse(here, fmt::format("index {} is {} and there are {} vertices",
                                                    beyond - indices.begin(), *beyond, vertex_count));
  }
  return indices;
}

}  // namespace ssrkit
