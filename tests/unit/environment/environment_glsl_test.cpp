// The shaders' text of the environment's lookups, compiled as C++ with GLM, against the maps that the host
// makes.
#include <glm/glm.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "environment/environment_maps.h"
#include "environment/octahedral.h"
#include "environment/sky.h"
#include "environment/split_sum.h"

namespace glsl {
using glm::abs;
using glm::clamp;
using glm::exp2;
using glm::floor;
using glm::log2;
using glm::min;
using glm::mix;
using glm::sqrt;
using glm::vec2;
using glm::vec3;
#include "environment.glsl"
#include "sky.glsl"

// Bilinear from the maps, as a sampler does it.
std::vector<ssrkit::OctahedralMap> maps;

vec3 load_environment(vec2 uv, float mip) {
  const ssrkit::OctahedralMap& map = maps[static_cast<std::size_t>(mip)];
  const vec2 position = uv * static_cast<float>(map.side) - 0.5F;
  const int x = clamp(static_cast<int>(position.x), 0, map.side - 2);
  const int y = clamp(static_cast<int>(position.y), 0, map.side - 2);
  const vec2 weight = position - vec2(x, y);
  return mix(mix(map.at(x, y), map.at(x + 1, y), weight.x),
             mix(map.at(x, y + 1), map.at(x + 1, y + 1), weight.x), weight.y);
}
}  // namespace glsl

namespace ssrkit {
namespace {

class EnvironmentGlsl : public ::testing::Test {
 protected:
  // Each mip of another colour, so that a blend tells which it is of; the directions in red and green.
  void SetUp() override {
    glsl::maps.clear();
    for (int mip = 0; mip < 5; ++mip) {
      OctahedralMap map(256 >> mip);
      for (int y = 1; y <= map.inner(); ++y) {
        for (int x = 1; x <= map.inner(); ++x) {
          const glm::vec3 direction = directionFromOctahedral(map.square(x, y));
          map.at(x, y) = glm::vec3(direction.x, direction.y, static_cast<float>(mip));
        }
      }
      map.wrapBorder();
      glsl::maps.push_back(std::move(map));
    }
  }
  const glsl::EnvironmentLayout layout_{256.0F, 5.0F, 32.0F, 64.0F};
};

TEST_F(EnvironmentGlsl, ReadsTheDirectionThatItIsAskedFor) {
  std::mt19937 random(5);
  std::normal_distribution<float> normal;
  for (int i = 0; i < 5000; ++i) {
    const glm::vec3 direction = glm::normalize(glm::vec3(normal(random), normal(random), normal(random)));
    for (int mip = 0; mip < 5; ++mip) {
      const glm::vec3 read = glsl::environment_radiance(direction, mipRoughness(mip, 5), layout_);
      const glm::vec3 expected = glsl::maps[static_cast<std::size_t>(mip)].sample(direction);
      EXPECT_LT(glm::distance(read, expected), 1e-3F) << mip;
    }
  }
}

TEST_F(EnvironmentGlsl, FindsEachMipAtItsRoughness) {
  for (const int mip_count : {5, 6, 7}) {
    for (int mip = 0; mip < mip_count; ++mip) {
      EXPECT_NEAR(glsl::environment_mip(mipRoughness(mip, mip_count), static_cast<float>(mip_count)),
                  static_cast<float>(mip), 1e-4F);
    }
    float before = -1.0F;
    for (int i = 0; i <= 1000; ++i) {
      const float mip = glsl::environment_mip(static_cast<float>(i) / 1000.0F, static_cast<float>(mip_count));
      EXPECT_GT(mip, before);
      before = mip;
    }
  }
}

TEST_F(EnvironmentGlsl, FindsTheSplitSumsEntries) {
  for (const int column : {0, 1, 20, 63}) {
    for (const int row : {0, 7, 63}) {
      const float root = static_cast<float>(column) / static_cast<float>(kSplitSumSide - 1);
      const glm::vec2 uv = glsl::split_sum_uv(root * root, static_cast<float>(row) / 63.0F, layout_);
      EXPECT_NEAR(uv.x * 64.0F, static_cast<float>(column) + 0.5F, 1e-4F);
      EXPECT_NEAR(uv.y * 64.0F, static_cast<float>(row) + 0.5F, 1e-4F);
    }
  }
}

TEST_F(EnvironmentGlsl, SkyIsTheHosts) {
  const glm::vec3 horizon(0.55F, 0.65F, 0.75F);
  const glm::vec3 zenith(0.18F, 0.30F, 0.55F);
  for (int i = -100; i <= 100; ++i) {
    const float elevation = static_cast<float>(i) / 100.0F;
    EXPECT_EQ(glsl::sky_radiance(elevation, horizon, zenith), skyRadiance(elevation, horizon, zenith));
  }
}

}  // namespace
}  // namespace ssrkit
