#include "oracle/alpha_cutout.h"

#include <algorithm>
#include <cmath>

namespace ssrkit {

namespace {

// The texel that a coordinate beyond the texture's edges stands for.
int wrapped(long long texel, int length, Wrap wrap) {
  switch (wrap) {
    case Wrap::kClamp:
      return static_cast<int>(std::clamp<long long>(texel, 0, length - 1));
    case Wrap::kMirror: {
      const long long period = 2LL * length;
      const long long within = ((texel % period) + period) % period;
      return static_cast<int>(within < length ? within : period - 1 - within);
    }
    case Wrap::kRepeat:
      break;
  }
  return static_cast<int>(((texel % length) + length) % length);
}

}  // namespace

float alphaCutoff(const Material& material) {
  constexpr float kBlendedAsMask = 0.5F;
  switch (material.alpha_mode) {
    case AlphaMode::kOpaque:
      return -1.0F;
    case AlphaMode::kBlend:
      return kBlendedAsMask;
    case AlphaMode::kMask:
      break;
  }
  return material.alpha_cutoff;
}

float sampleAlpha(const Texture& texture, glm::vec2 uv) {
  const glm::dvec2 at =
      glm::dvec2(uv) * glm::dvec2(texture.size.width, texture.size.height) - glm::dvec2(0.5);
  constexpr double kFarthest = 1e15;  // whole numbers this large are exact, and fit a long long
  if (!(std::abs(at.x) < kFarthest && std::abs(at.y) < kFarthest)) {
    return 1.0F;
  }
  const glm::dvec2 corner = glm::floor(at);
  const glm::dvec2 weight = at - corner;
  const auto alphaOf = [&](int dx, int dy) {
    const int x = wrapped(static_cast<long long>(corner.x) + dx, texture.size.width, texture.wrap_u);
    const int y = wrapped(static_cast<long long>(corner.y) + dy, texture.size.height, texture.wrap_v);
    const auto texel = static_cast<std::size_t>(y) * static_cast<std::size_t>(texture.size.width) +
                       static_cast<std::size_t>(x);
    return texture.rgba[4 * texel + 3] / 255.0;
  };
  const double upper = glm::mix(alphaOf(0, 0), alphaOf(1, 0), weight.x);
  const double lower = glm::mix(alphaOf(0, 1), alphaOf(1, 1), weight.x);
  return static_cast<float>(glm::mix(upper, lower, weight.y));
}

bool isDrawnAt(const Scene& scene, const Material& material, glm::vec2 uv) {
  float alpha = material.base_colour.a;
  if (material.base_colour_texture >= 0) {
    alpha *= sampleAlpha(scene.textures[static_cast<std::size_t>(material.base_colour_texture)], uv);
  }
  return !(alpha < alphaCutoff(material));
}

}  // namespace ssrkit
