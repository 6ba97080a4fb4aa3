// The lighting passes at every texel against scalar code in double precision.
#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/packing.hpp>
#include <limits>

#include "environment/octahedral.h"
#include "lit_surfaces.h"

namespace ssrkit {
namespace {

constexpr double kBackgroundDist = std::numeric_limits<double>::infinity();
const std::vector<Format> kTwo{Format::kRgba32f, Format::kRgba32f};

EnvironmentMaps constantMaps(double radiance) {
  const auto maps = environmentMaps(
      {.file = {}, .horizon = glm::vec3(static_cast<float>(radiance)), .zenith = {}, .is_constant = true});
  EXPECT_TRUE(maps.has_value());
  return maps.value_or(EnvironmentMaps{});
}

// Every mip shows the direction that it is looked at from.
EnvironmentMaps directionMaps() {
  EnvironmentMaps maps = constantMaps(0.0);
  const auto fill = [](HalfMap& map) {
    OctahedralMap directions(map.side);
    for (int y = 1; y <= directions.inner(); ++y) {
      for (int x = 1; x <= directions.inner(); ++x) {
        directions.at(x, y) = 1.5F + directionFromOctahedral(directions.square(x, y));
      }
    }
    directions.wrapBorder();
    for (std::size_t i = 0; i < directions.texels.size(); ++i) {
      for (int channel = 0; channel < 3; ++channel) {
        map.rgba[4 * i + static_cast<std::size_t>(channel)] =
            glm::packHalf1x16(directions.texels[i][channel]);
      }
    }
  };
  std::ranges::for_each(maps.mips, fill);
  fill(maps.irradiance);
  return maps;
}

std::string compared(const Image& image, const std::function<glm::dvec3(int x, int y)>& expected,
                     double tolerance) {
  for (int y = 0; y < image.size.height; ++y) {
    for (int x = 0; x < image.size.width; ++x) {
      const glm::dvec3 right = expected(x, y);
      for (int channel = 0; channel < 3; ++channel) {
        const auto got = static_cast<double>(image.at(x, y, static_cast<std::size_t>(channel)));
        if (!(std::abs(got - right[channel]) <= tolerance * (1.0 + right[channel]))) {
          return fmt::format("{}, {} channel {}: {} where {} is right", x, y, channel, got, right[channel]);
        }
      }
    }
  }
  return "";
}

class LightTest : public LitTest {
 protected:
  [[nodiscard]] static const LitSurface& at(const std::vector<LitSurface>& surfaces, int x, int y) {
    return surfaces[litIndex(x, y)];
  }
};

TEST_P(LightTest, GgxIsTheScalarSumAtEveryTexel) {
  const std::vector<LitSurface> surfaces = manySurfaces();
  const double sky = 0.375;
  const EnvironmentMaps maps = constantMaps(sky);
  const auto check = [&](const std::string& shader) -> std::string {
    begin();
    giveSurfaces(surfaces, manyLights());
    give(maps);
    const std::vector<Image> images = drawAll(shader, kLitSize, kTwo);
    const auto base = [&](int x, int y) {
      const LitSurface& surface = at(surfaces, x, y);
      const GgxReference reference = ggxReference(surface, rayOf(x, y), manyLights(), maps.split_sum);
      return surface.emission + reference.direct + surface.ao * reference.diffuse_albedo * sky;
    };
    const std::string base_wrong = compared(images[1], base, 2e-4);
    return !base_wrong.empty() ? base_wrong
                               : compared(
                                     images[0],
                                     [&](int x, int y) {
                                       return base(x, y) + sky * ggxReference(at(surfaces, x, y), rayOf(x, y),
                                                                              {}, maps.split_sum)
                                                                     .specular_albedo;
                                     },
                                     2e-4);
  };
  holdsAndKills(check, "light_ggx.frag", {"light_ggx_alpha_is_roughness", "light_ggx_shadow_on_every_light"});
}

TEST_P(LightTest, MetalsShowTheEnvironmentWhereTheyMirrorIt) {
  const glm::dmat4 view_from_world =
      glm::rotate(glm::rotate(glm::dmat4(1.0), 0.7, glm::dvec3(1, 0, 0)), 2.1, glm::dvec3(0, 1, 0));
  std::vector<LitSurface> surfaces = manySurfaces();
  for (LitSurface& surface : surfaces) {
    surface.albedo = glm::dvec3(1.0);
    surface.metallic = 1.0;
    surface.roughness = 0.0;
  }
  const auto check = [&](const std::string& shader) {
    begin();
    giveSurfaces(surfaces, {}, view_from_world);
    give(directionMaps());
    const auto mirrored = [&](int x, int y) {
      const glm::dvec3 direction = glm::reflect(glm::normalize(rayOf(x, y)), at(surfaces, x, y).normal);
      return at(surfaces, x, y).emission + 1.5 + glm::transpose(glm::dmat3(view_from_world)) * direction;
    };
    return compared(drawAll(shader, kLitSize, kTwo)[0], mirrored, 2e-3);
  };
  holdsAndKills(check, "light_ggx.frag", {"light_ggx_environment_in_view_space"});
}

TEST_P(LightTest, DiffuseSurfacesShowTheirNormalsIrradiance) {
  const glm::dmat4 view_from_world = glm::rotate(glm::dmat4(1.0), 1.3, glm::normalize(glm::dvec3(1, 2, 0)));
  std::vector<LitSurface> surfaces = manySurfaces();
  for (LitSurface& surface : surfaces) {
    surface.metallic = 0.0;
    surface.emission = glm::dvec3(0.0);
  }
  giveSurfaces(surfaces, {}, view_from_world);
  const EnvironmentMaps maps = directionMaps();
  give(maps);
  const auto expected = [&](int x, int y) {
    const LitSurface& surface = at(surfaces, x, y);
    const glm::dvec3 irradiance = 1.5 + glm::transpose(glm::dmat3(view_from_world)) * surface.normal;
    return surface.ao * ggxReference(surface, rayOf(x, y), {}, maps.split_sum).diffuse_albedo * irradiance;
  };
  EXPECT_EQ(compared(drawAll("light_ggx.frag", kLitSize, kTwo)[1], expected, 0.015),
            "");  // of 32 texels a side
}

TEST_P(LightTest, BackgroundIsTheEnvironment) {
  const glm::dmat4 view_from_world = glm::rotate(glm::dmat4(1.0), -0.6, glm::normalize(glm::dvec3(1, 1, 0)));
  const std::vector<LitSurface> surfaces(litIndex(0, kLitSize.height),
                                         LitSurface{.dist_view = kBackgroundDist});
  giveSurfaces(surfaces, manyLights(), view_from_world);
  give(directionMaps());
  const std::vector<Image> images = drawAll("light_ggx.frag", kLitSize, kTwo);
  const auto seen = [&](int x, int y) {
    return 1.5 + glm::transpose(glm::dmat3(view_from_world)) * glm::normalize(rayOf(x, y));
  };
  EXPECT_EQ(compared(images[0], seen, 2e-3), "");
  EXPECT_EQ(difference(images[0], images[1], 0.0), "");
}

// The root of the elevation's sine, and below the horizon its ground: written out once more.
TEST_P(LightTest, TheSkyRisesFromTheHorizonToTheZenith) {
  const glm::dvec3 horizon(0.5, 0.6, 0.7);
  const glm::dvec3 zenith(0.1, 0.2, 0.9);
  const glm::dvec3 up = glm::normalize(glm::dvec3(0.2, 0.9, 0.1));
  const std::vector<LitSurface> surfaces(litIndex(0, kLitSize.height),
                                         LitSurface{.dist_view = kBackgroundDist});
  giveSurfaces(surfaces, manyLights());
  values_.set("up_view", up);
  values_.set("sky_horizon", horizon);
  values_.set("sky_zenith", zenith);
  const auto sky = [&](int x, int y) {
    const double elevation = glm::dot(glm::normalize(rayOf(x, y)), up);
    const glm::dvec3 above = glm::mix(horizon, zenith, std::sqrt(std::max(elevation, 0.0)));
    return glm::mix(above, 0.35 * horizon, std::clamp(-4.0 * elevation, 0.0, 1.0));
  };
  EXPECT_EQ(compared(draw("light.frag", kLitSize), sky, 1e-3), "");
}

TEST_P(LightTest, BlinnPhongIsTheScalarSumAtEveryTexel) {
  const std::vector<LitSurface> surfaces = manySurfaces();
  const glm::dvec3 horizon(0.5, 0.6, 0.7);
  const auto check = [&](const std::string& shader) {
    begin();
    giveSurfaces(surfaces, manyLights());
    values_.set("up_view", glm::dvec3(0, 1, 0));
    values_.set("sky_horizon", horizon);
    values_.set("sky_zenith", glm::dvec3(0.1));
    const auto expected = [&](int x, int y) {
      return blinnPhongReference(at(surfaces, x, y), rayOf(x, y), manyLights(), horizon);
    };
    return compared(draw(shader, kLitSize), expected, 1e-3);
  };
  holdsAndKills(check, "light.frag", {"light_lobe_not_normalised"});
}

// Surfaces and lights as broken files bring them: every answer is a finite number, and what it is, is stated.
TEST_P(LightTest, StaysFiniteWithoutNormalsAndWithLightsOnTheSurface) {
  std::vector<LitSurface> surfaces = manySurfaces();
  std::vector<LitSurface> facing = surfaces;
  for (int x = 0; x < kLitSize.width; ++x) {
    surfaces[static_cast<std::size_t>(x)].normal = glm::dvec3(x % 2 == 0 ? 0.0 : std::nan(""));
    facing[static_cast<std::size_t>(x)].normal = -glm::normalize(rayOf(x, 0));
  }
  std::vector<TestLight> lights = manyLights();
  lights[2].place = glm::dvec3(0.0);                             // in the camera
  lights[3].place = rayOf(5, 3) * at(surfaces, 5, 3).dist_view;  // on a surface
  lights[4] = {.place = rayOf(7, 6) * (at(surfaces, 7, 6).dist_view - 1e-7), .strength = glm::dvec3(1e9)};
  for (const std::string shader : {"light_ggx.frag", "light.frag"}) {
    begin();
    values_.set("up_view", glm::dvec3(0, 1, 0));
    values_.set("sky_horizon", glm::dvec3(0.5));
    values_.set("sky_zenith", glm::dvec3(0.1));
    giveSurfaces(surfaces, lights);
    give(constantMaps(0.5));
    const std::size_t count = shader == "light.frag" ? 1 : 2;
    const std::vector<Image> broken =
        drawAll(shader, kLitSize, {kTwo.begin(), kTwo.begin() + static_cast<long>(count)});
    giveSurfaces(facing, lights);
    const std::vector<Image> mended =
        drawAll(shader, kLitSize, {kTwo.begin(), kTwo.begin() + static_cast<long>(count)});
    for (std::size_t i = 0; i < count; ++i) {
      for (const float value : broken[i].data) {
        ASSERT_TRUE(value >= 0.0F && value <= 65504.0F) << shader << " " << value;
      }
      // A surface without a normal faces the viewer.
      EXPECT_EQ(difference(broken[i], mended[i], 0.0), "") << shader;
    }
  }
}

TEST_P(LightTest, WithoutLightsTheEnvironmentRemains) {
  const std::vector<LitSurface> surfaces = manySurfaces();
  const EnvironmentMaps maps = constantMaps(0.5);
  giveSurfaces(surfaces, {});
  give(maps);
  const auto expected = [&](int x, int y) {
    const LitSurface& surface = at(surfaces, x, y);
    const GgxReference reference = ggxReference(surface, rayOf(x, y), {}, maps.split_sum);
    return surface.emission + 0.5 * (surface.ao * reference.diffuse_albedo + reference.specular_albedo);
  };
  EXPECT_EQ(compared(drawAll("light_ggx.frag", kLitSize, kTwo)[0], expected, 2e-4), "");
}

INSTANTIATE_TEST_SUITE_P(Each, LightTest, testing::Values("gl-osmesa", "vk-lavapipe"), deviceTestName);

}  // namespace
}  // namespace ssrkit
