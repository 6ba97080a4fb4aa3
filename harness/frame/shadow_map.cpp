#include "frame/shadow_map.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

#include "device/pass_clock.h"
#include "frame/geometry_pass.h"
#include "frame/image_transfer.h"
#include "frame/shadow_projection.h"

namespace ssrkit {

namespace {

constexpr std::array<double, 4> kFarthest{1.0, 0.0, 0.0, 0.0};

// xy of the first texel's corner in metres, metres a texel, and 1 / that.
glm::dvec4 cascadeUniform(const ShadowCascade& cascade) {
  return {cascade.origin_m, cascade.texel_m, 1.0 / cascade.texel_m};
}

PassRow casterPass(const std::string& name) {
  return {.name = name,
          .vertex_shader = "shadow_map.vert",
          .fragment_shader = name + ".frag",
          .colour_formats = {},
          .depth_test = DepthTest::kNearer,
          .vertex_attributes = vertexAttributes(),
          .vertex_stride_bytes = sizeof(Vertex)};
}

std::vector<DrawRange> rangesOf(const Scene& scene, bool is_masked) {
  std::vector<DrawRange> ranges;
  std::ranges::copy_if(scene.ranges, std::back_inserter(ranges), [&](const DrawRange& range) {
    const Material& material = scene.materials[static_cast<std::size_t>(range.material_index)];
    return (material.alpha_mode != AlphaMode::kOpaque) == is_masked;
  });
  return ranges;
}

Size shadowMapSize(int cascade_count) {
  return {cascade_count * kShadowSideTexels, kShadowSideTexels};
}

Expected<DeviceImage*> shadowMapImage(FrameImages& images, int cascade_count) {
  return images.getSized(
      {.name = "shadow_map", .format = Format::kD32f, .size = shadowMapSize(cascade_count), .mip_count = 1});
}

}  // namespace

const PassRow& shadowMapPass() {
  static const PassRow row = casterPass("shadow_map");
  return row;
}

const PassRow& shadowMapMaskedPass() {
  static const PassRow row = casterPass("shadow_map_masked");
  return row;
}

Expected<ShadowMapPrograms> shadowMapPrograms(Programs& programs, const CompileSettings& settings) {
  const auto opaque = programs.get(shadowMapPass(), settings);
  if (!opaque) {
    return tl::make_unexpected(opaque.error());
  }
  const auto masked = programs.get(shadowMapMaskedPass(), settings);
  if (!masked) {
    return tl::make_unexpected(masked.error());
  }
  return ShadowMapPrograms{.opaque = *opaque, .masked = *masked};
}

int setShadowUniforms(UniformValues& values, const Scene& scene, const Camera& camera) {
  const glm::dvec3 direction = scene.directional_lights.empty()
                                   ? glm::dvec3(0, -1, 0)
                                   : scene.directional_lights.front().direction_world;
  const ShadowProjection fit = fitShadow(direction, worldBounds(scene), camera);
  values.set("light_from_world", fit.light_from_world);
  values.set("light_from_view", fit.light_from_world * glm::inverse(camera.view_from_world));
  values.set("shadow_near_m", fit.near_m);
  values.set("shadow_range_m", fit.range_m);
  values.set("shadow_side_texels", static_cast<double>(kShadowSideTexels));
  const auto count = static_cast<int>(fit.cascades.size());
  const Size size = shadowMapSize(count);
  values.set("shadow_atlas_texel_uv", 1.0 / glm::dvec2(size.width, size.height));
  std::vector<glm::dvec4> cascades(kShadowMaxCascades);  // of zeros where there is none: they hold no point
  std::ranges::transform(fit.cascades, cascades.begin(), cascadeUniform);
  values.set("shadow_cascades", cascades);
  return count;
}

Expected<PassTime> drawShadowMap(Device& device, const ShadowMapPrograms& programs, int cascade_count,
                                 const Scene& scene, const SceneResources& resources, FrameImages& images,
                                 const UniformValues& values) {
  const auto image = shadowMapImage(images, cascade_count);
  if (!image) {
    return tl::make_unexpected(image.error());
  }
  struct Casters {
    const PassRow* row;
    const Program* program;
    std::vector<DrawRange> ranges;
  };
  const std::array kinds = {Casters{&shadowMapPass(), programs.opaque, rangesOf(scene, false)},
                            Casters{&shadowMapMaskedPass(), programs.masked, rangesOf(scene, true)}};
  UniformValues of_cascade = values;
  PassTime sum{.wall_ns = 0, .cpu_ns = 0, .device_ns = 0};
  bool is_cleared = false;
  for (int cascade = 0; cascade < cascade_count; ++cascade) {
    of_cascade.set("shadow_cascade", cascade);
    for (const Casters& casters : kinds) {
      if (is_cleared && casters.ranges.empty()) {
        continue;
      }
      const GeometryPass pass{
          .row = casters.row,
          .ranges = casters.ranges,
          .colour = {},
          // Clears are of the whole image: the first draw's is for all.
          .depth = {*image, 0, is_cleared ? std::nullopt : std::optional(kFarthest)},
          .viewport = {cascade * kShadowSideTexels, 0, kShadowSideTexels, kShadowSideTexels}};
      const auto time = drawGeometry(device, *casters.program, pass, scene, resources, of_cascade);
      if (!time) {
        return time;
      }
      sum += *time;
      is_cleared = true;
    }
  }
  return sum;
}

Expected<void> clearShadowMap(Device& device, FrameImages& images) {
  const auto image = shadowMapImage(images, 1);
  return image ? fillImage(device, **image, {1.0F, 1.0F, 1.0F, 1.0F}) : tl::make_unexpected(image.error());
}

}  // namespace ssrkit
