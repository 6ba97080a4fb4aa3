#include "lit_surfaces.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "environment/split_sum.h"

namespace ssrkit {

namespace {

constexpr double kPi = std::numbers::pi;

double lambda(double cosine, double alpha) {
  return (std::sqrt(1.0 + alpha * alpha * (1.0 / (cosine * cosine) - 1.0)) - 1.0) / 2.0;
}

// Bilinear, as a sampler reads it.
glm::dvec2 splitSumAt(const std::vector<float>& table, double cos_view, double roughness) {
  const double x = std::sqrt(cos_view) * (kSplitSumSide - 1);
  const double y = roughness * (kSplitSumSide - 1);
  const int column = std::min(static_cast<int>(x), kSplitSumSide - 2);
  const int row = std::min(static_cast<int>(y), kSplitSumSide - 2);
  const auto entry = [&](int i, int j) {
    const std::size_t at = static_cast<std::size_t>(j) * kSplitSumSide + static_cast<std::size_t>(i);
    return glm::dvec2(table[2 * at], table[2 * at + 1]);
  };
  const glm::dvec2 upper = glm::mix(entry(column, row), entry(column + 1, row), x - column);
  const glm::dvec2 lower = glm::mix(entry(column, row + 1), entry(column + 1, row + 1), x - column);
  return glm::mix(upper, lower, y - row);
}

std::array<double, 4> rgba(glm::dvec3 colour) {
  return {colour.r, colour.g, colour.b, 1.0};
}

}  // namespace

glm::dvec3 rayOf(int x, int y) {
  return {0.05 * (x + 0.5 - 8.0), -0.05 * (y + 0.5 - 4.0), -1.0};
}

std::vector<LitSurface> manySurfaces() {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit;
  const auto colour = [&] { return glm::dvec3(unit(random), unit(random), unit(random)); };
  std::vector<LitSurface> surfaces;
  for (int y = 0; y < kLitSize.height; ++y) {
    for (int x = 0; x < kLitSize.width; ++x) {
      const glm::dvec3 to_eye = -glm::normalize(rayOf(x, y));
      const double lean = x == 3 ? 1.02 : unit(random);
      const glm::dvec3 side = glm::normalize(glm::cross(to_eye, colour() - 0.5));
      surfaces.push_back({.albedo = y == 0 ? glm::dvec3(0.0) : colour(),
                          .metallic = y % 3 == 0   ? 1.0
                                      : y % 3 == 1 ? 0.0
                                                   : unit(random),
                          .roughness = x == 0 ? 0.0 : unit(random),
                          .normal = std::cos(lean * kPi / 2.0) * to_eye + std::sin(lean * kPi / 2.0) * side,
                          .dist_view = 2.0 + 4.0 * unit(random),
                          .emission = x == 5 ? colour() : glm::dvec3(0.0),
                          .shadow = unit(random),
                          .ao = unit(random),
                          .is_traced = x % 2 == 0});
    }
  }
  return surfaces;
}

std::vector<TestLight> manyLights() {
  const glm::dvec3 down = glm::normalize(glm::dvec3(0.3, -1.0, -0.4));
  const glm::dvec3 back = glm::normalize(glm::dvec3(-0.5, 0.2, -0.9));
  return {{.is_directional = true, .place = down, .strength = {3.0, 2.5, 2.0}},
          {.is_directional = true, .place = back, .strength = {0.2, 0.5, 1.0}},
          {.place = {1.0, 1.0, -2.0}, .strength = {4.0, 1.0, 1.0}},
          {.place = {-1.0, 0.5, -1.0}, .strength = {1.0, 6.0, 2.0}, .range_m = 4.5},
          {.place = {0.0, 1.0, 0.0},
           .strength = {8.0, 8.0, 8.0},
           .axis = glm::normalize(glm::dvec3(0.1, -0.3, -1.0)),
           .inner = 0.98,
           .outer = 0.9}};
}

Arriving arriving(const TestLight& light, glm::dvec3 p_view) {
  if (light.is_directional) {
    return {-light.place, light.strength};
  }
  const glm::dvec3 offset = light.place - p_view;
  const double distance = glm::length(offset);
  double falloff = 1.0 / std::max(distance * distance, 1e-4);
  if (light.range_m > 0.0) {
    falloff *= std::clamp(1.0 - std::pow(distance / light.range_m, 4.0), 0.0, 1.0);
  }
  if (light.outer > -1.0) {
    const double cone = glm::dot(-offset / distance, light.axis);
    falloff *= std::pow(std::clamp((cone - light.outer) / (light.inner - light.outer), 0.0, 1.0), 2.0);
  }
  return {offset / distance, light.strength * falloff};
}

GgxReference ggxReference(const LitSurface& surface, glm::dvec3 ray, const std::vector<TestLight>& lights,
                          const std::vector<float>& split_sum) {
  const glm::dvec3 view = -glm::normalize(ray);
  const double cos_view = std::clamp(glm::dot(surface.normal, view), 1e-3, 1.0);
  const double light_roughness = std::max(surface.roughness, 0.15);
  const double alpha = light_roughness * light_roughness;
  const glm::dvec3 f0 = glm::mix(glm::dvec3(0.04), surface.albedo, surface.metallic);
  const double f90 = std::min(50.0 * std::max({f0.r, f0.g, f0.b}), 1.0);
  const auto more = [&](glm::dvec2 split) { return 1.0 + f0 * (1.0 / (split.x + split.y) - 1.0); };
  const auto albedo = [&](glm::dvec2 split) { return (f0 * split.x + f90 * split.y) * more(split); };
  const glm::dvec2 split = splitSumAt(split_sum, cos_view, surface.roughness);
  const glm::dvec3 diffuse = surface.albedo * (1.0 - surface.metallic);
  GgxReference reference;
  reference.specular_albedo = albedo(split);
  reference.diffuse_albedo = diffuse * (1.0 - reference.specular_albedo);
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const auto [to_light, irradiance] = arriving(lights[i], ray * surface.dist_view);
    const double cos_light = glm::dot(surface.normal, to_light);
    if (cos_light <= 0.0) {
      continue;
    }
    const glm::dvec3 half_vector = glm::normalize(to_light + view);
    const double cos_half = std::clamp(glm::dot(surface.normal, half_vector), 0.0, 1.0);
    const double d = alpha * alpha / (kPi * std::pow(cos_half * cos_half * (alpha * alpha - 1.0) + 1.0, 2.0));
    const double g = 1.0 / (1.0 + lambda(cos_light, alpha) + lambda(cos_view, alpha));
    const glm::dvec3 fresnel = f0 + (f90 - f0) * std::pow(1.0 - glm::dot(view, half_vector), 5.0);
    const glm::dvec3 brdf =
        diffuse * (1.0 - albedo(split)) / kPi + fresnel * more(split) * d * g / (4.0 * cos_light * cos_view);
    reference.direct += (i == 0 ? surface.shadow : 1.0) * brdf * irradiance * cos_light;
  }
  return reference;
}

glm::dvec3 blinnPhongReference(const LitSurface& surface, glm::dvec3 ray,
                               const std::vector<TestLight>& lights, glm::dvec3 sky_horizon) {
  const glm::dvec3 view = -glm::normalize(ray);
  const double shininess = 2.0 / std::pow(std::max(surface.roughness, 0.15), 4.0) - 2.0;
  const glm::dvec3 diffuse = surface.albedo * (1.0 - surface.metallic);
  const glm::dvec3 specular = glm::mix(glm::dvec3(0.04), surface.albedo, surface.metallic);
  glm::dvec3 radiance = surface.emission + 0.25 * diffuse * sky_horizon;
  for (const TestLight& light : lights) {
    const auto [to_light, irradiance] = arriving(light, ray * surface.dist_view);
    const double cos_half = std::max(glm::dot(surface.normal, glm::normalize(to_light + view)), 0.0);
    const double lobe = std::pow(cos_half, shininess) * (shininess + 8.0) / (8.0 * kPi);
    radiance +=
        (diffuse / kPi + specular * lobe) * irradiance * std::max(glm::dot(surface.normal, to_light), 0.0);
  }
  return radiance;
}

void LitTest::giveSurfaces(const std::vector<LitSurface>& surfaces, const std::vector<TestLight>& lights,
                           const glm::dmat4& view_from_world) {
  values_.set("px_offset", glm::dvec2(8.0, 4.0));
  values_.set("view_per_px", glm::dvec2(0.05, -0.05));
  values_.set("texel_uv", glm::dvec2(1.0 / kLitSize.width, 1.0 / kLitSize.height));
  values_.set("view_from_world", view_from_world);
  std::array<std::vector<glm::dvec4>, 5> rows;
  rows.fill(std::vector<glm::dvec4>(8, glm::dvec4(0.0)));
  std::size_t suns = 0;
  std::size_t points = 0;
  for (const TestLight& light : lights) {
    if (light.is_directional) {
      rows[0][suns] = glm::dvec4(light.place, 0.0);
      rows[1][suns++] = glm::dvec4(light.strength, 0.0);
    } else {
      rows[2][points] = glm::dvec4(light.place, light.range_m);
      rows[3][points] = glm::dvec4(light.axis, light.outer);
      rows[4][points++] = glm::dvec4(light.strength, light.inner);
    }
  }
  setConstant("directional_count", static_cast<int>(suns));
  setConstant("point_count", static_cast<int>(points));
  values_.set("directional_dir_view", rows[0]);
  values_.set("directional_radiance", rows[1]);
  values_.set("point_p_view", rows[2]);
  values_.set("point_dir_view", rows[3]);
  values_.set("point_intensity", rows[4]);
  const auto of = [&](const auto& value) {
    return imageOf(kLitSize, [&](int x, int y) { return value(surfaces[litIndex(x, y)]); });
  };
  give("albedo", of([](const LitSurface& s) { return rgba(s.albedo); }));
  give("normal_view", of([](const LitSurface& s) { return rgba(s.normal); }));
  give("emission", of([](const LitSurface& s) { return rgba(s.emission); }));
  give("material", of([](const LitSurface& s) {
         return std::array{s.metallic, s.roughness, s.is_traced ? 1.0 : 0.0, 1.0};
       }));
  give("dist_view", of([](const LitSurface& s) { return std::array{s.dist_view, 0.0, 0.0, 0.0}; }));
  give("shadow", of([](const LitSurface& s) { return std::array{s.shadow, 0.0, 0.0, 0.0}; }));
  give("ao", of([](const LitSurface& s) { return std::array{s.ao, 0.0, 0.0, 0.0}; }));
}

}  // namespace ssrkit
