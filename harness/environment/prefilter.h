// The environment seen through a GGX lobe and through a cosine lobe, as octahedral maps.
#pragma once

#include <functional>
#include <vector>

#include "environment/octahedral.h"

namespace ssrkit {

// Radiance that arrives from a unit direction in world space.
using RadianceFunction = std::function<glm::vec3(glm::vec3)>;

// The environment's own radiance at falling resolution, each level half as fine as the one before, down to 4
// texels. `side` must be a power of two; each texel is the mean of `samples_a_side`^2 points of it.
[[nodiscard]] std::vector<OctahedralMap> radianceChain(const RadianceFunction& radiance, int side,
                                                       int samples_a_side);

// The mean radiance of each texel, at full sharpness: what a mirror shows. `side` counts the border.
[[nodiscard]] OctahedralMap sharpMap(const RadianceFunction& radiance, int side, int samples_a_side);

// The split sum's first factor for one roughness: the mean of the radiance over GGX's reflected directions
// with the viewer along the normal, weighted by their cosine (Karis, "Real Shading in Unreal Engine 4",
// SIGGRAPH 2013 course). Each sample reads the level of the chain whose texels are as large as the sample's
// share of the lobe (Krivanek and Colbert, "Real-time Shading with Filtered Importance Sampling", EGSR 2008,
// section 4).
[[nodiscard]] OctahedralMap ggxMap(const std::vector<OctahedralMap>& chain, float roughness, int side,
                                   int sample_count);

// Irradiance over pi: the radiance's mean, weighted by the cosine; a white diffuse surface shows it.
[[nodiscard]] OctahedralMap cosineMap(const std::vector<OctahedralMap>& chain, int side);

}  // namespace ssrkit
