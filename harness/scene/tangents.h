#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace ssrkit {

// A tangent for each vertex of an indexed mesh: the direction in which u grows, averaged over the vertex's
// triangles, made perpendicular to its normal; w makes cross(normal, tangent) * w point up in the image,
// against v. Where the texture coordinates give no direction, any perpendicular one.
[[nodiscard]] std::vector<glm::vec4> tangentsFromUv(std::span<const glm::vec3> positions,
                                                    std::span<const glm::vec3> normals,
                                                    std::span<const glm::vec2> uvs,
                                                    std::span<const std::uint32_t> triangles);

}  // namespace ssrkit
