// The split sum's second factor (Karis, "Real Shading in Unreal Engine 4", SIGGRAPH 2013 course): what a GGX
// surface reflects of a white environment is F0 * scale + bias. Lagarde and de Rousiers, "Moving Frostbite to
// PBR", SIGGRAPH 2014 course, section 4.9.2, for the notation; the lobe is that of
// shaders/include/brdf_ggx.glsl.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace ssrkit {

inline constexpr int kSplitSumSide = 64;

// Scale and bias for one cosine to the viewer and one perceptual roughness (alpha = roughness^2), both in (0,
// 1], by numeric integration with 256 points.
[[nodiscard]] glm::vec2 splitSum(float cos_view, float roughness);

// kSplitSumSide^2 entries: rows of roughness and columns of the square root of the cosine, each from 0 to 1
// at the middles of the first and the last texel. The root gives the steep edge at grazing angles more
// columns.
[[nodiscard]] std::vector<glm::vec2> splitSumTable();

}  // namespace ssrkit
