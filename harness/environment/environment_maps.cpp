#include "environment/environment_maps.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "base/atomic_file.h"
#include "base/entry_cache.h"
#include "base/hash128.h"
#include "environment/equirect.h"
#include "environment/prefilter.h"
#include "environment/sky.h"
#include "environment/split_sum.h"

namespace ssrkit {

namespace {

// Raise it when any number that is computed here, or how it is stored, changes.
constexpr int kVersion = 2;
constexpr int kCoarsestSide = 16;
constexpr int kIrradianceSide = 32;
constexpr int kGradientSide = 256;
constexpr int kFileSide = 512;  // at least: mip 1 is then for roughness 0.25, near enough to the sharp mip 0
constexpr int kLargestSide = 1024;

struct Plan {
  int side = kGradientSide;
  int samples_a_side = 2;
};

HalfMap halves(const OctahedralMap& map) {
  HalfMap stored{.side = map.side, .rgba = {}};
  stored.rgba.reserve(map.texels.size() * 4);
  for (const glm::vec3& texel : map.texels) {
    for (const float value : {texel.r, texel.g, texel.b, 1.0F}) {
      stored.rgba.push_back(glm::packHalf1x16(value));
    }
  }
  return stored;
}

template <class T>
std::string bytesOf(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

template <class T>
bool takeBytes(std::string_view& bytes, std::vector<T>& values, std::size_t count) {
  if (bytes.size() < count * sizeof(T)) {
    return false;
  }
  values.resize(count);
  std::memcpy(values.data(), bytes.data(), count * sizeof(T));
  bytes.remove_prefix(count * sizeof(T));
  return true;
}

bool takeMap(std::string_view& bytes, HalfMap& map, int side) {
  map.side = side;
  return takeBytes(bytes, map.rgba, static_cast<std::size_t>(side) * static_cast<std::size_t>(side) * 4);
}

std::string bytesOf(const EnvironmentMaps& maps) {
  std::string bytes = bytesOf(std::vector<std::int32_t>{maps.mips.front().side});
  for (const HalfMap& mip : maps.mips) {
    bytes += bytesOf(mip.rgba);
  }
  return bytes + bytesOf(maps.irradiance.rgba);
}

std::optional<EnvironmentMaps> mapsFromBytes(std::string_view bytes) {
  EnvironmentMaps maps;
  std::vector<std::int32_t> finest_side;
  if (!takeBytes(bytes, finest_side, 1) || finest_side[0] < kCoarsestSide || finest_side[0] > kLargestSide) {
    return std::nullopt;
  }
  for (int side = finest_side[0]; side >= kCoarsestSide; side /= 2) {
    if (!takeMap(bytes, maps.mips.emplace_back(), side)) {
      return std::nullopt;
    }
  }
  if (!takeMap(bytes, maps.irradiance, kIrradianceSide) || !bytes.empty()) {
    return std::nullopt;
  }
  maps.from_cache = true;
  return maps;
}

EnvironmentMaps computeMaps(const RadianceFunction& radiance, const Plan& plan) {
  // Four times the samples for a quarter of the texels: every mip costs the same, and the wide lobes, where
  // few samples would show, have the most.
  constexpr int kFewestSamples = 64;
  constexpr int kMostSamples = 1024;
  const std::vector<OctahedralMap> chain = radianceChain(radiance, plan.side, plan.samples_a_side);
  const int mip_count = static_cast<int>(std::bit_width(static_cast<unsigned>(plan.side / kCoarsestSide)));
  EnvironmentMaps maps;
  maps.mips.push_back(halves(sharpMap(radiance, plan.side, plan.samples_a_side)));
  for (int mip = 1; mip < mip_count; ++mip) {
    const int sample_count = std::min(kFewestSamples << (2 * (mip - 1)), kMostSamples);
    maps.mips.push_back(halves(ggxMap(chain, mipRoughness(mip, mip_count), plan.side >> mip, sample_count)));
  }
  maps.irradiance = halves(cosineMap(chain, kIrradianceSide));
  return maps;
}

std::vector<float> cachedSplitSum(const EntryCache& cache) {
  const std::string recipe = fmt::format("split sum {}", kSplitSumSide);
  constexpr std::size_t kCount = std::size_t{2} * kSplitSumSide * kSplitSumSide;
  std::vector<float> table;
  if (const auto kept = cache.find(recipe); kept) {
    std::string_view bytes = *kept;
    if (takeBytes(bytes, table, kCount) && bytes.empty()) {
      return table;
    }
  }
  table.clear();
  for (const glm::vec2& entry : splitSumTable()) {
    table.insert(table.end(), {entry.x, entry.y});
  }
  cache.store(recipe, bytesOf(table));
  return table;
}

Expected<EnvironmentMaps> gradientMaps(const EnvironmentSource& source) {
  return computeMaps(
      [&source](glm::vec3 direction) {
        return source.is_constant ? source.horizon : skyRadiance(direction.y, source.horizon, source.zenith);
      },
      {});
}

Expected<EnvironmentMaps> fileMaps(const std::filesystem::path& file) {
  return readEquirect(file).map([](const Image& image) {
    // Twice the file's height: along the diagonals of the square, where the horizon lies, two texels are one.
    const auto wanted = 2U * static_cast<unsigned>(image.size.height);
    const int side = std::clamp(static_cast<int>(std::bit_ceil(wanted)), kFileSide, kLargestSide);
    return computeMaps([&image](glm::vec3 direction) { return sampleEquirect(image, direction); },
                       {.side = side, .samples_a_side = std::max(2, image.size.height / side + 1)});
  });
}

// Everything that decides the maps.
Expected<std::string> recipeOf(const EnvironmentSource& source) {
  if (source.file.empty()) {
    return fmt::format("gradient {} {} {} {} {} {} {}", source.is_constant, source.horizon.r,
                       source.horizon.g, source.horizon.b, source.zenith.r, source.zenith.g, source.zenith.b);
  }
  return readFile(source.file, kMaxEquirectBytes).map([](const std::string& bytes) {
    return fmt::format("equirect {} {}", bytes.size(), hashName(bytes));
  });
}

}  // namespace

float mipRoughness(int mip, int mip_count) {
  return mip == 0 ? 0.0F : std::exp2(0.5F * static_cast<float>(mip - (mip_count - 1)));
}

Expected<EnvironmentMaps> environmentMaps(const EnvironmentSource& source) {
  const EntryCache cache = EntryCache::ofUser("environment", kVersion);
  const auto recipe = recipeOf(source);
  if (!recipe) {
    return inputError("read the environment", recipe.error().problem, source.file.string(),
                      recipe.error().remedy);
  }
  const auto kept = cache.find(*recipe);
  if (auto maps = kept ? mapsFromBytes(*kept) : std::nullopt; maps) {
    maps->split_sum = cachedSplitSum(cache);
    return std::move(*maps);
  }
  auto maps = source.file.empty() ? gradientMaps(source) : fileMaps(source.file);
  if (maps) {
    cache.store(*recipe, bytesOf(*maps));
    maps->split_sum = cachedSplitSum(cache);
  }
  return maps;
}

}  // namespace ssrkit
