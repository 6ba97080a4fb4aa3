#include "environment/prefilter.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "base/share_out.h"
#include "environment/low_discrepancy.h"
#include "environment/pi.h"

namespace ssrkit {

namespace {

constexpr int kCoarsestInner = 4;

// Every texel inside the border, a row a piece of work.
void fillRows(OctahedralMap& map, const std::function<glm::vec3(int, int)>& texel) {
  forEachInParallel(map.inner(), 0, [&](int row) {
    for (int x = 1; x <= map.inner(); ++x) {
      map.at(x, row + 1) = texel(x, row + 1);
    }
  });
  map.wrapBorder();
}

OctahedralMap halved(const OctahedralMap& fine) {
  OctahedralMap coarse(fine.inner() / 2 + 2);
  fillRows(coarse, [&](int x, int y) {
    glm::vec3 sum(0.0F);
    float weights = 0.0F;
    for (const int dy : {0, 1}) {
      for (const int dx : {0, 1}) {
        const int fine_x = 2 * x - 1 + dx;
        const int fine_y = 2 * y - 1 + dy;
        const float weight = fine.solidAngle(fine_x, fine_y);
        sum += weight * fine.at(fine_x, fine_y);
        weights += weight;
      }
    }
    return sum / weights;
  });
  return coarse;
}

// One reflected direction about +z, its weight, and the level of the chain that it reads.
struct LobeSample {
  glm::vec3 direction;
  float weight;
  int level;
};

std::vector<LobeSample> lobeSamples(float roughness, int sample_count, int finest_inner, int level_count) {
  const float alpha2 = std::pow(roughness, 4.0F);
  const float texel_solid_angle = 4.0F * kPi / static_cast<float>(finest_inner * finest_inner);
  std::vector<LobeSample> samples;
  for (int i = 0; i < sample_count; ++i) {
    const glm::vec2 point = hammersley(i, sample_count);
    // GGX's half vectors by density D cos (Walter et al., EGSR 2007, eq. 35 and 36).
    const float cos2 = (1.0F - point.x) / (1.0F + (alpha2 - 1.0F) * point.x);
    const float cosine = std::sqrt(cos2);
    const float sine = std::sqrt(std::max(1.0F - cos2, 0.0F));
    const float azimuth = 2.0F * kPi * point.y;
    const glm::vec3 reflected(2.0F * cosine * sine * std::cos(azimuth),
                              2.0F * cosine * sine * std::sin(azimuth), 2.0F * cos2 - 1.0F);
    if (reflected.z <= 0.0F) {
      continue;
    }
    const float shape = cos2 * (alpha2 - 1.0F) + 1.0F;
    const float density = alpha2 / (kPi * shape * shape) / 4.0F;  // with the viewer along the normal
    const float share = 1.0F / (static_cast<float>(sample_count) * density);
    const float level = 0.5F * std::log2(share / texel_solid_angle);
    samples.push_back(
        {reflected, reflected.z, std::clamp(static_cast<int>(std::lround(level)), 0, level_count - 1)});
  }
  return samples;
}

// A turn of +z onto the direction, without a pole of its own (Duff et al., "Building an Orthonormal Basis,
// Revisited", JCGT 6(1) 2017).
glm::mat3 basisAround(glm::vec3 z) {
  const float sign = z.z < 0.0F ? -1.0F : 1.0F;
  const float a = -1.0F / (sign + z.z);
  const float b = z.x * z.y * a;
  return {glm::vec3(1.0F + sign * z.x * z.x * a, sign * b, -sign * z.x),
          glm::vec3(b, sign + z.y * z.y * a, -z.y), z};
}

}  // namespace

OctahedralMap sharpMap(const RadianceFunction& radiance, int side, int samples_a_side) {
  OctahedralMap map(side);
  const float step = 1.0F / static_cast<float>(samples_a_side);
  fillRows(map, [&](int x, int y) {
    glm::vec3 sum(0.0F);
    for (int j = 0; j < samples_a_side; ++j) {
      for (int i = 0; i < samples_a_side; ++i) {
        const glm::vec2 in_texel = (glm::vec2(static_cast<float>(i), static_cast<float>(j)) + 0.5F) * step;
        sum += radiance(directionFromOctahedral(map.square(x, y, in_texel)));
      }
    }
    return sum * (step * step);
  });
  return map;
}

std::vector<OctahedralMap> radianceChain(const RadianceFunction& radiance, int side, int samples_a_side) {
  std::vector<OctahedralMap> chain{sharpMap(radiance, side + 2, samples_a_side)};
  while (chain.back().inner() > kCoarsestInner) {
    chain.push_back(halved(chain.back()));
  }
  return chain;
}

OctahedralMap ggxMap(const std::vector<OctahedralMap>& chain, float roughness, int side, int sample_count) {
  SSRKIT_CHECK(!chain.empty());
  const std::vector<LobeSample> samples =
      lobeSamples(roughness, sample_count, chain.front().inner(), static_cast<int>(chain.size()));
  float weights = 0.0F;
  for (const LobeSample& sample : samples) {
    weights += sample.weight;
  }
  OctahedralMap map(side);
  fillRows(map, [&](int x, int y) {
    const glm::mat3 basis = basisAround(directionFromOctahedral(map.square(x, y)));
    glm::vec3 sum(0.0F);
    for (const LobeSample& sample : samples) {
      sum += sample.weight * chain[static_cast<std::size_t>(sample.level)].sample(basis * sample.direction);
    }
    return sum / weights;
  });
  return map;
}

OctahedralMap cosineMap(const std::vector<OctahedralMap>& chain, int side) {
  // Texels of 64 a side are 2.8 degrees wide: over a cosine lobe a finer source changes nothing.
  constexpr int kEnough = 64;
  const auto source =
      std::ranges::find_if(chain, [](const OctahedralMap& level) { return level.inner() <= kEnough; });
  SSRKIT_CHECK(source != chain.end());
  struct Patch {
    glm::vec3 direction;
    glm::vec3 power;  // radiance times solid angle
    float solid_angle;
  };
  std::vector<Patch> patches;
  for (int y = 1; y <= source->inner(); ++y) {
    for (int x = 1; x <= source->inner(); ++x) {
      const float solid_angle = source->solidAngle(x, y);
      patches.push_back(
          {directionFromOctahedral(source->square(x, y)), solid_angle * source->at(x, y), solid_angle});
    }
  }
  OctahedralMap map(side);
  fillRows(map, [&](int x, int y) {
    const glm::vec3 normal = directionFromOctahedral(map.square(x, y));
    glm::vec3 sum(0.0F);
    float weights = 0.0F;
    for (const Patch& patch : patches) {
      const float cosine = std::max(glm::dot(normal, patch.direction), 0.0F);
      sum += cosine * patch.power;
      weights += cosine * patch.solid_angle;
    }
    return sum / weights;
  });
  return map;
}

}  // namespace ssrkit
