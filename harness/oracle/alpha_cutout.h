// Where a material is cut out: the alpha test of shaders/gbuffer.frag, for points that no rasteriser shades.
#pragma once

#include <glm/glm.hpp>

#include "scene/scene.h"

namespace ssrkit {

// The least alpha of a texel that is drawn; negative where everything is.
[[nodiscard]] float alphaCutoff(const Material& material);

// The alpha of an 8-bit texture at a texture coordinate, bilinear as the devices filter it, 0..1.
[[nodiscard]] float sampleAlpha(const Texture& texture, glm::vec2 uv);

// Whether the surface is drawn at this texture coordinate.
[[nodiscard]] bool isDrawnAt(const Scene& scene, const Material& material, glm::vec2 uv);

}  // namespace ssrkit
