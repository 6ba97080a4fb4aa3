// The prefiltered maps against integrals in double precision and closed forms.
#include "environment/prefilter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "environment/environment_maps.h"
#include "environment/sky.h"

namespace ssrkit {
namespace {

constexpr glm::vec3 kHorizon{0.55F, 0.65F, 0.75F};
constexpr glm::vec3 kZenith{0.18F, 0.30F, 0.55F};

glm::vec3 gradient(glm::vec3 direction) {
  return skyRadiance(direction.y, kHorizon, kZenith);
}

// A bright disc of 20 degrees' half-angle about +x in a dark world.
glm::vec3 disc(glm::vec3 direction) {
  return glm::vec3(direction.x > 0.9397F ? 5.0F : 0.1F);
}

// The mean over reflected directions about `normal`, weighted by D and the cosine, by a plain sum over all
// directions.
glm::dvec3 lobeMean(const RadianceFunction& radiance, glm::dvec3 normal, double roughness) {
  constexpr int kPolar = 1600;
  constexpr int kAzimuth = 400;
  const double alpha2 = std::pow(roughness, 4.0);
  const glm::dvec3 side = glm::normalize(
      glm::cross(normal, std::abs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1)));
  const glm::dvec3 other = glm::cross(normal, side);
  glm::dvec3 sum(0.0);
  double weights = 0.0;
  for (int i = 0; i < kPolar; ++i) {
    const double u = (i + 0.5) / kPolar;
    const double angle = std::numbers::pi / 2.0 * u * u;  // finer near the middle
    const double width = std::numbers::pi * u;
    const double cos_half = std::cos(angle / 2.0);
    const double shape = cos_half * cos_half * (alpha2 - 1.0) + 1.0;
    const double weight = std::cos(angle) * std::sin(angle) * width / (shape * shape);
    for (int j = 0; j < kAzimuth; ++j) {
      const double azimuth = 2.0 * std::numbers::pi * (j + 0.5) / kAzimuth;
      const glm::dvec3 direction =
          std::cos(angle) * normal + std::sin(angle) * (std::cos(azimuth) * side + std::sin(azimuth) * other);
      sum += weight * glm::dvec3(radiance(glm::vec3(direction)));
      weights += weight;
    }
  }
  return sum / weights;
}

TEST(Prefilter, KeepsAConstantAtEveryRoughness) {
  const glm::vec3 colour(0.5F, 2.0F, 0.25F);
  const auto chain = radianceChain([&](glm::vec3) { return colour; }, 64, 2);
  for (const float roughness : {0.05F, 0.25F, 0.5F, 0.707F, 1.0F}) {
    for (const glm::vec3& texel : ggxMap(chain, roughness, 16, 128).texels) {
      EXPECT_LT(glm::distance(texel, colour), 2e-6F) << roughness;
    }
  }
  for (const glm::vec3& texel : cosineMap(chain, 16).texels) {
    EXPECT_LT(glm::distance(texel, colour), 2e-6F);
  }
}

// Texels of every mip as environmentMaps() makes them, against the sum over all directions.
TEST(Prefilter, GgxIsTheLobesMean) {
  struct Case {
    RadianceFunction radiance;
    double tolerance;
  };
  for (const Case& each : {Case{gradient, 0.0075}, Case{disc, 0.08}}) {
    const auto chain = radianceChain(each.radiance, 256, 2);
    constexpr int kMips = 5;
    for (int mip = 1; mip < kMips; ++mip) {
      const float roughness = mipRoughness(mip, kMips);
      const OctahedralMap map = ggxMap(chain, roughness, 256 >> mip, std::min(64 << (2 * (mip - 1)), 1024));
      for (const glm::dvec2 place :
           {glm::dvec2(0.9, 0.5), {0.8, 0.45}, {0.97, 0.6}, {0.5, 0.5}, {0.1, 0.1}}) {
        const int x = 1 + static_cast<int>(place.x * map.inner());
        const int y = 1 + static_cast<int>(place.y * map.inner());
        const glm::dvec3 normal = directionFromOctahedral(map.square(x, y));
        const glm::dvec3 expected =
            lobeMean(each.radiance, glm::normalize(normal), static_cast<double>(roughness));
        EXPECT_LT(glm::distance(glm::dvec3(map.at(x, y)), expected), each.tolerance)
            << "mip " << mip << " at " << x << ", " << y << ": " << map.at(x, y).r << " for " << expected.r;
      }
    }
  }
}

// Under a sky of radiance max(y, 0), a surface whose normal is the angle g away from up has irradiance over
// pi of 2 / (3 pi) ((pi - g) cos g + sin g).
TEST(Prefilter, CosineIsTheIrradianceInClosedForm) {
  const auto chain =
      radianceChain([](glm::vec3 direction) { return glm::vec3(std::max(direction.y, 0.0F)); }, 256, 2);
  const OctahedralMap map = cosineMap(chain, 32);
  double worst = 0.0;
  for (int y = 0; y < map.side; ++y) {
    for (int x = 0; x < map.side; ++x) {
      const bool on_border = x == 0 || y == 0 || x == map.side - 1 || y == map.side - 1;
      if (!on_border) {
        const double angle = std::acos(static_cast<double>(directionFromOctahedral(map.square(x, y)).y));
        const double expected =
            2.0 / (3.0 * std::numbers::pi) * ((std::numbers::pi - angle) * std::cos(angle) + std::sin(angle));
        worst = std::max(worst, std::abs(static_cast<double>(map.at(x, y).g) - expected));
      }
    }
  }
  EXPECT_LT(worst, 2e-3);
}

TEST(Prefilter, TheChainKeepsTheMeanRadiance) {
  const auto chain = radianceChain(disc, 256, 4);
  for (const OctahedralMap& level : chain) {
    if (level.inner() < 32) {
      continue;  // there the solid angle of a texel's centre no longer stands for the texel's
    }
    double sum = 0.0;
    for (int y = 1; y <= level.inner(); ++y) {
      for (int x = 1; x <= level.inner(); ++x) {
        sum += static_cast<double>(level.solidAngle(x, y) * level.at(x, y).r);
      }
    }
    const double share = (1.0 - 0.9397) / 2.0;  // of the sphere, within the disc
    EXPECT_NEAR(sum / (4.0 * std::numbers::pi), 0.1 + share * 4.9, 1e-3) << level.inner();
  }
}

TEST(Prefilter, MipsHalveAlpha) {
  EXPECT_EQ(mipRoughness(0, 5), 0.0F);
  EXPECT_EQ(mipRoughness(4, 5), 1.0F);
  for (int mip = 2; mip < 7; ++mip) {
    EXPECT_NEAR(std::pow(mipRoughness(mip, 7), 2.0F), 2.0F * std::pow(mipRoughness(mip - 1, 7), 2.0F), 1e-6F);
  }
}

}  // namespace
}  // namespace ssrkit
