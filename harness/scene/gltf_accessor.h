#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "scene/gltf_document.h"

namespace ssrkit {

inline constexpr std::size_t kMaxVertices = 20'000'000;  // of a scene, and elements of an accessor

// The bytes of a buffer view, checked against its buffer. `place` is where the view is used, for the error.
[[nodiscard]] Expected<std::span<const std::uint8_t>> bytesOfView(const GltfDocument& document,
                                                                  int buffer_view, const std::string& place);

// The accessor's elements one after the other, `components` floats each (1: SCALAR, 2..4: VEC2..VEC4).
// Integers become the fractions they stand for where the accessor is normalised, plain values otherwise;
// sparse values are put in.
[[nodiscard]] Expected<std::vector<float>> readFloats(const GltfDocument& document, int accessor,
                                                      int components, const std::string& place);

// An accessor of unsigned integers as the indices of a primitive; fails when one is `vertex_count` or more.
[[nodiscard]] Expected<std::vector<std::uint32_t>> readIndices(const GltfDocument& document, int accessor,
                                                               std::size_t vertex_count,
                                                               const std::string& place);

}  // namespace ssrkit
