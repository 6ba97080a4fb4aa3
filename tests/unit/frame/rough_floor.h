// M1's floor made rough, before a wall that is dark on its left half and bright on its right: a G-buffer by
// formula, and the radiance that its pixels reflect, by quadrature over their microfacets, each of which
// Oracle A traces.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <map>
#include <string>
#include <vector>

#include "image/image.h"
#include "spaces/camera.h"

namespace ssrkit {

constexpr Size kFloorSize{64, 64};
constexpr int kFirstFloorRow = 40;
constexpr double kFloorRoughness = 0.3125;  // exact in the G-buffer's half precision
const glm::dvec3 kFloorHorizon{0.5, 0.5, 0.5};
const glm::dvec3 kFloorZenith{0.25, 0.25, 0.25};

// Of the floor's columns.
using RoughnessOf = std::function<double(int x)>;

[[nodiscard]] const Camera& floorCamera();
[[nodiscard]] std::map<std::string, Image> floorGbuffer(const RoughnessOf& roughness_of);

// Cosine between the floor's normal and the direction to the eye.
[[nodiscard]] double floorCosine(int x, int y);

// What a floor pixel reflects, and the variance of one sample of it.
struct FloorPixel {
  int x;
  int y;
  double mean;
  double variance;
};
[[nodiscard]] std::vector<FloorPixel> floorIntegrals(const RoughnessOf& roughness_of);

}  // namespace ssrkit
