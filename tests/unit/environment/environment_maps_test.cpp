#include "environment/environment_maps.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <glm/gtc/packing.hpp>
#include <iterator>
#include <thread>

#include "environment/split_sum.h"
#include "image/exr.h"
#include "temporary_folder.h"

namespace ssrkit {
namespace {

namespace fs = std::filesystem;

// Each test has a cache of its own.
class Environment : public ::testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(setenv("XDG_CACHE_HOME", (folder_ / "cache").c_str(), 1), 0); }

  [[nodiscard]] static EnvironmentMaps maps(const EnvironmentSource& source = kGradient) {
    auto made = environmentMaps(source);
    EXPECT_TRUE(made) << sentence(made.error());
    return made ? std::move(*made) : EnvironmentMaps{};
  }
  [[nodiscard]] std::vector<fs::path> entries() const {
    std::vector<fs::path> paths;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_ / "cache/ssrkit/environment")) {
      paths.push_back(entry.path());
    }
    return paths;
  }

  static inline const EnvironmentSource kGradient{
      .file = {}, .horizon = {0.5F, 0.6F, 0.7F}, .zenith = {0.1F, 0.2F, 0.4F}, .is_constant = false};
  test::TemporaryFolder folder_;
};

bool sameNumbers(const EnvironmentMaps& a, const EnvironmentMaps& b) {
  const auto same = [](const HalfMap& left, const HalfMap& right) {
    return left.side == right.side && left.rgba == right.rgba;
  };
  return std::equal(a.mips.begin(), a.mips.end(), b.mips.begin(), b.mips.end(), same) &&
         same(a.irradiance, b.irradiance) && a.split_sum == b.split_sum;
}

TEST_F(Environment, HasMipsDownTo16TexelsAndItsTables) {
  const EnvironmentMaps made = maps();
  ASSERT_EQ(made.mips.size(), 5U);
  for (std::size_t mip = 0; mip < made.mips.size(); ++mip) {
    EXPECT_EQ(made.mips[mip].side, 256 >> mip);
    EXPECT_EQ(made.mips[mip].rgba.size(), std::size_t{4} * (256 >> mip) * (256 >> mip));
  }
  EXPECT_EQ(made.irradiance.side, 32);
  EXPECT_EQ(made.split_sum.size(), std::size_t{2} * kSplitSumSide * kSplitSumSide);
}

TEST_F(Environment, ThatIsConstantIsTheConstantAtEveryTexelOfEveryMap) {
  const EnvironmentMaps made =
      maps({.file = {}, .horizon = {0.5F, 3.0F, 0.0F}, .zenith = {}, .is_constant = true});
  std::vector<HalfMap> all = made.mips;
  all.push_back(made.irradiance);
  for (const HalfMap& map : all) {
    for (std::size_t i = 0; i < map.rgba.size(); i += 4) {
      EXPECT_EQ(glm::unpackHalf1x16(map.rgba[i]), 0.5F);
      EXPECT_EQ(glm::unpackHalf1x16(map.rgba[i + 1]), 3.0F);
      EXPECT_EQ(glm::unpackHalf1x16(map.rgba[i + 2]), 0.0F);
      EXPECT_EQ(glm::unpackHalf1x16(map.rgba[i + 3]), 1.0F);
    }
  }
}

TEST_F(Environment, ComesFromTheCacheTheSecondTimeWithTheSameBits) {
  const EnvironmentMaps cold = maps();
  const EnvironmentMaps warm = maps();
  EXPECT_FALSE(cold.from_cache);
  EXPECT_TRUE(warm.from_cache);
  EXPECT_TRUE(sameNumbers(cold, warm));
  EnvironmentSource other = kGradient;
  other.zenith.b += 1e-6F;
  EXPECT_FALSE(maps(other).from_cache);
}

TEST_F(Environment, IsMadeAnewFromDamagedEntries) {
  const EnvironmentMaps cold = maps();
  for (const fs::path& entry : entries()) {
    std::ifstream file(entry, std::ios::binary);
    std::string bytes(std::istreambuf_iterator<char>(file), {});
    for (const std::size_t at : {std::size_t{3}, bytes.size() / 2, bytes.size() - 1}) {
      std::string damaged = bytes;
      damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
      std::ofstream(entry, std::ios::binary) << damaged;
      EXPECT_TRUE(sameNumbers(maps(), cold)) << entry << " byte " << at;
    }
    fs::resize_file(entry, bytes.size() / 2);
    EXPECT_TRUE(sameNumbers(maps(), cold)) << entry;
  }
  EXPECT_TRUE(maps().from_cache);
}

TEST_F(Environment, ServesSeveralThreadsAtOnce) {
  std::vector<EnvironmentMaps> made(3);
  {
    std::vector<std::jthread> threads;
    threads.reserve(made.size());
    for (EnvironmentMaps& each : made) {
      threads.emplace_back([&each] { each = maps(); });
    }
  }
  EXPECT_TRUE(sameNumbers(made[0], made[1]) && sameNumbers(made[0], made[2]));
  EXPECT_EQ(entries().size(), 2U);  // the maps and the split sum's table, no file left over
}

TEST_F(Environment, NeedsNoCache) {
  std::ofstream(folder_ / "cache") << "a file stands where the folder should be";
  EXPECT_FALSE(maps().from_cache);
  EXPECT_FALSE(maps().from_cache);
}

TEST_F(Environment, FromAFileShowsWhatStandsThere) {
  // Up is red, the half towards +x green and the other half blue.
  Image image({64, 32}, {"R", "G", "B"});
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 64; ++x) {
      image.at(x, y, 0) = y < 4 ? 2.0F : 0.0F;
      image.at(x, y, 1) = x >= 32 ? 1.0F : 0.0F;
      image.at(x, y, 2) = x < 32 ? 1.0F : 0.0F;
    }
  }
  const EnvironmentSource source{.file = folder_ / "sky.exr", .horizon = {}, .zenith = {}};
  ASSERT_TRUE(writeExr(source.file, image));
  const EnvironmentMaps made = maps(source);
  const auto texel = [&](int x, int y, int channel) {
    const std::size_t at = static_cast<std::size_t>(y) * 512 + static_cast<std::size_t>(x);
    return glm::unpackHalf1x16(made.mips[0].rgba[4 * at + static_cast<std::size_t>(channel)]);
  };
  ASSERT_EQ(made.mips[0].side, 512);
  EXPECT_EQ(texel(256, 256, 0), 2.0F);
  EXPECT_EQ(texel(10, 10, 0), 0.0F);
  EXPECT_EQ(texel(500, 256, 1), 1.0F);
  EXPECT_EQ(texel(500, 256, 2), 0.0F);
  EXPECT_EQ(texel(10, 256, 2), 1.0F);
  EXPECT_TRUE(maps(source).from_cache);
  image.at(0, 31, 2) = 0.5F;
  ASSERT_TRUE(writeExr(source.file, image));
  EXPECT_FALSE(maps(source).from_cache);  // another content under the same name
}

TEST_F(Environment, FromABadFileIsRefused) {
  const auto made = environmentMaps({.file = folder_ / "none.exr", .horizon = {}, .zenith = {}});
  ASSERT_FALSE(made);
  EXPECT_NE(sentence(made.error()).find("none.exr: could not read the environment"), std::string::npos)
      << sentence(made.error());
}

}  // namespace
}  // namespace ssrkit
