#include "shadow_scene_test.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "../kit_shaders.h"
#include "frame/gbuffer_source.h"
#include "frame/shadow_map.h"

namespace ssrkit {

Camera shadowCamera(const glm::dvec3& position, double pitch_rad, Size size) {
  Camera camera{.size = size,
                .clip_from_view = perspective(2.0 * std::atan(0.5),
                                              static_cast<double>(size.width) / size.height, 0.1, 100.0),
                .view_from_world = glm::dmat4(1.0),
                .near_m = 0.1,
                .far_m = 100.0};
  const double c = std::cos(pitch_rad);
  const double s = std::sin(pitch_rad);
  const glm::dmat3 world_from_view(glm::dvec3(1, 0, 0), glm::dvec3(0, c, s), glm::dvec3(0, -s, c));
  const glm::dmat3 rotation = glm::transpose(world_from_view);
  camera.view_from_world = glm::dmat4(rotation);
  camera.view_from_world[3] = glm::dvec4(-(rotation * position), 1.0);
  return camera;
}

glm::dvec3 lightFrom(double elevation_deg, double azimuth_deg) {
  const double e = elevation_deg * std::numbers::pi / 180.0;
  const double a = azimuth_deg * std::numbers::pi / 180.0;
  return {-std::cos(e) * std::sin(a), -std::sin(e), -std::cos(e) * std::cos(a)};
}

std::string allAre(const Image& shadow, float value) {
  const auto count = std::ranges::count_if(shadow.data, [&](float lit) { return lit != value; });
  return count == 0 ? "" : fmt::format("{} of {} pixels are not {}", count, shadow.data.size(), value);
}

void ShadowTest::giveScene(const Scene& scene, const Camera& camera) {
  begin();
  size_ = camera.size;
  setCameraUniforms(values_, camera);
  setLightUniforms(values_, scene, camera.view_from_world);
  const int cascade_count = setShadowUniforms(values_, scene, camera);
  auto resources = uploadScene(*device_, scene);
  ASSERT_TRUE(resources.has_value());
  if (scene_programs_ == nullptr) {
    scene_programs_ = std::make_unique<Programs>(*device_, target_);
  }
  const CompileSettings settings{.shader_root = kitShaders()};
  const auto gbuffer = scene_programs_->get(gbufferPassFor(settings, scene), settings);
  const auto map = shadowMapPrograms(*scene_programs_, settings);
  ASSERT_TRUE(gbuffer.has_value() && map.has_value());
  FrameImages images(*device_, camera.size);
  ASSERT_TRUE(drawGbuffer(*device_, **gbuffer, scene, *resources, images, values_).has_value());
  const auto mapped = drawShadowMap(*device_, *map, cascade_count, scene, *resources, images, values_);
  ASSERT_TRUE(mapped.has_value()) << sentence(mapped.error());
  dist_view_ = *readImage(*device_, *images.find("dist_view"), {"Z"});
  material_ = *readImage(*device_, *images.find("material"), {"R", "G", "B", "A"});
  dist_range_ = *readImage(*device_, *images.find("dist_range"), {"X", "Y"});
  normal_view_ = *readImage(*device_, *images.find("normal_view"), {"R", "G", "B", "A"});
  give("dist_view", dist_view_, Format::kR32f);
  give("normal_view", normal_view_);
  give("shadow_map", *readImage(*device_, *images.find("shadow_map"), {"Z"}), Format::kR32f);
}

}  // namespace ssrkit
