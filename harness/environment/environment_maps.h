// Everything that image-based lighting looks up, made once on the host, so that every device has the same
// bits: prefiltered mips, irradiance, the split-sum table. Kept in the user's cache by the hash of what they
// are made from.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <vector>

#include "base/error.h"

namespace ssrkit {

// What arrives from where the scene ends. A constant environment is a gradient between two equal colours with
// the ground's factor left out.
struct EnvironmentSource {
  std::filesystem::path file;  // an equirectangular EXR; empty: the gradient
  glm::vec3 horizon{0.0F};
  glm::vec3 zenith{0.0F};
  bool is_constant = false;  // `horizon` everywhere
};

// A square map of half floats, RGBA, row 0 first, border included (environment/octahedral.h).
struct HalfMap {
  int side = 0;
  std::vector<std::uint16_t> rgba;
};

struct EnvironmentMaps {
  std::vector<HalfMap> mips;  // each half the side of the one before, down to 16; roughness by mipRoughness()
  HalfMap irradiance;         // over pi
  std::vector<float> split_sum;  // kSplitSumSide^2 pairs
  bool from_cache = false;
};

// Mip 0 is sharp. From the last, at roughness 1, each finer mip halves alpha: lobe and texel shrink together.
[[nodiscard]] float mipRoughness(int mip, int mip_count);

// Reads the cache or computes on all cores. Fails only on a bad file.
[[nodiscard]] Expected<EnvironmentMaps> environmentMaps(const EnvironmentSource& source);

}  // namespace ssrkit
