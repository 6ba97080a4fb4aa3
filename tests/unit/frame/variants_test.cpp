// The same job asked in another way gives the same bits, on each device; and what a wrong driver would do to
// a variant is seen.
#include "frame/variants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <map>
#include <set>
#include <span>

#include "device/forwarding_device.h"
#include "frame/run_job.h"
#include "frame/tiled_device.h"
#include "frame_device.h"
#include "hit_bits.h"
#include "made_gbuffers.h"

namespace ssrkit {
namespace {

constexpr Size kVariantsSize{67, 41};  // tiles and quads do not fit

Job tracesOf(const std::string& variant) {
  Job job = randomBlocks(kVariantsSize);
  job.traces = {{.stage = "walk"}, {.stage = "dda"}, {.stage = "hiz"}, {.stage = "refined"}};
  job.variant = variant;
  return job;
}

std::vector<std::uint32_t> bitsOf(const TraceResult& trace) {
  std::vector<std::uint32_t> bits;
  for (const RayHit& ray : trace.record.rays) {
    for (const float value : {ray.px_x, ray.px_y, ray.t_m}) {
      bits.push_back(std::bit_cast<std::uint32_t>(value));
    }
    bits.push_back(static_cast<std::uint32_t>(ray.texel_x));
    bits.push_back(static_cast<std::uint32_t>(ray.texel_y));
    bits.push_back(static_cast<std::uint32_t>(ray.ray_class));
    bits.push_back(ray.lookups);
    bits.push_back(ray.steps);
  }
  for (const auto& [name, image] : trace.images) {
    for (const float value : image.data) {
      bits.push_back(std::bit_cast<std::uint32_t>(value));
    }
  }
  return bits;
}

// Of every trace, by its stage; empty where the job failed, which is a failure of the test.
std::map<std::string, std::vector<std::uint32_t>> answers(Device& device, ShaderTarget target,
                                                          const Job& job) {
  std::map<std::string, std::vector<std::uint32_t>> by_stage;
  const auto result = JobRunner(device, target).run(job, [](const std::string&) {});
  EXPECT_TRUE(result.has_value()) << sentence(result.error());
  if (result) {
    for (const TraceResult& trace : result->traces) {
      by_stage.emplace(trace.stage, bitsOf(trace));
    }
  }
  return by_stage;
}

// Ends each tile a column early: a seam.
class LosesASeam final : public ForwardingDevice {
 public:
  using ForwardingDevice::ForwardingDevice;
  [[nodiscard]] Expected<PassTime> draw(const PassDesc& pass) override {
    PassDesc wrong = pass;
    if (pass.scissor && pass.scissor->width < pass.viewport.width) {
      wrong.scissor->width = std::max(pass.scissor->width - 1, 0);
    }
    return behind().draw(wrong);
  }
};

// Leaves the last tile of each pass undrawn.
class LosesATile final : public ForwardingDevice {
 public:
  using ForwardingDevice::ForwardingDevice;
  [[nodiscard]] Expected<PassTime> draw(const PassDesc& pass) override {
    PassDesc wrong = pass;
    const Rect& viewport = pass.viewport;
    if (pass.scissor && pass.scissor->x > viewport.x && pass.scissor->y > viewport.y) {
      wrong.scissor = Rect{viewport.x, viewport.y, 1, 1};
    }
    return behind().draw(wrong);
  }
};

class VariantsTest : public FrameDeviceTest {};

TEST_P(VariantsTest, EachGivesThePlainJobsBits) {
  const auto plain = answers(*device_, target_, tracesOf(""));
  ASSERT_EQ(plain.size(), 4U);
  for (const Variant& variant : variants()) {
    if (variant.view == ViewChange{}) {
      EXPECT_EQ(answers(*device_, target_, tracesOf(variant.name)), plain) << variant.name;
    }
  }
}

// Fills each pass's block as the first job with that pass laid it out.
class KeepsTheFirstLayout final : public ForwardingDevice {
 public:
  using ForwardingDevice::ForwardingDevice;
  [[nodiscard]] Expected<PassTime> draw(const PassDesc& pass) override {
    auto& first = first_[pass.name];
    first.resize(std::max(first.size(), pass.uniforms.size()));
    if (seen_.insert(pass.name).second) {
      std::ranges::copy(pass.uniforms, first.begin());
    }
    PassDesc wrong = pass;
    wrong.uniforms = std::span(first).first(pass.uniforms.size());
    return behind().draw(wrong);
  }

 private:
  std::map<std::string, std::vector<std::byte>> first_;
  std::set<std::string> seen_;
};

// Takes every branch that asks for more than a zero.
class WakesTheDead final : public ForwardingDevice {
 public:
  using ForwardingDevice::ForwardingDevice;
  [[nodiscard]] Expected<PassTime> draw(const PassDesc& pass) override {
    std::vector<std::uint32_t> words(pass.uniforms.size() / sizeof(std::uint32_t));
    std::ranges::copy(pass.uniforms, std::as_writable_bytes(std::span(words)).begin());
    std::ranges::replace(words, std::bit_cast<std::uint32_t>(-0.0F), std::bit_cast<std::uint32_t>(2.0F));
    PassDesc wrong = pass;
    wrong.uniforms = std::as_bytes(std::span(words));
    return behind().draw(wrong);
  }
};

TEST_P(VariantsTest, AnotherOrderOfUniformsShowsADeviceThatGoesByOffset) {
  KeepsTheFirstLayout keeps(*device_);
  Job job = tracesOf("");
  job.traces.resize(1);
  const auto plain = answers(keeps, target_, job);
  EXPECT_EQ(answers(keeps, target_, job), plain);
  job.variant = "uniform_order";
  EXPECT_NE(answers(keeps, target_, job), plain);
}

TEST_P(VariantsTest, DeadCodeThatRunsIsSeen) {
  WakesTheDead wakes(*device_);
  EXPECT_NE(answers(wakes, target_, tracesOf("dead_code")), answers(*device_, target_, tracesOf("")));
}

// How many rays have another class or texel than the plain ones that the view shows, and how many of other
// bits; of the stage `hiz`.
struct Differences {
  std::size_t rays = 0;
  std::size_t answers = 0;
  std::size_t bits = 0;
};

Differences differencesIn(const std::string& variant, Device& device, ShaderTarget target) {
  Job job = randomTerrain({160, 90});
  job.traces = {{.stage = "hiz", .technique = ""}};
  const auto plain = JobRunner(device, target).run(job, [](const std::string&) {});
  job.variant = variant;
  const auto seen = JobRunner(device, target).run(job, [](const std::string&) {});
  if (!plain || !seen) {
    ADD_FAILURE() << sentence(plain ? seen.error() : plain.error());
    return {};
  }
  const RayRecord expected = recordIn((*findVariant(variant))->view, plain->traces[0].record);
  const RayRecord& found = seen->traces[0].record;
  EXPECT_EQ(found.size, expected.size);
  Differences differences;
  for (std::size_t i = 0; i < std::min(found.rays.size(), expected.rays.size()); ++i) {
    const RayHit& a = found.rays[i];
    const RayHit& b = expected.rays[i];
    const bool same = a.ray_class == b.ray_class && a.texel_x == b.texel_x && a.texel_y == b.texel_y;
    const bool has_ray = b.ray_class != RayClass::kMasked && b.ray_class != RayClass::kBackground;
    differences.rays += has_ray ? 1 : 0;
    differences.answers += same ? 0 : 1;
    differences.bits += same && pointBits(a) == pointBits(b) ? 0 : 1;
  }
  return differences;
}

TEST_P(VariantsTest, AWorldEightTimesAsLargeHasTheSameRaysBitByBit) {
  const Differences scaled = differencesIn("scaled", *device_, target_);
  EXPECT_GT(scaled.rays, 5000U);
  EXPECT_EQ(scaled.bits, 0U);
}

// Subtracting from the width rounds, and so does another origin of pixels: a ray on the border of two texels
// may fall to the other side.
TEST_P(VariantsTest, MirroringAndCroppingMoveTheRaysTexelByTexel) {
  for (const char* const variant : {"mirrored", "cropped"}) {
    const Differences seen = differencesIn(variant, *device_, target_);
    EXPECT_GT(seen.rays, 4000U) << variant;
    EXPECT_LE(seen.answers, seen.rays / 500) << variant;
  }
}

TEST_P(VariantsTest, TilesShowADeviceThatLosesTexels) {
  const auto plain = answers(*device_, target_, tracesOf(""));
  LosesASeam seam(*device_);
  EXPECT_EQ(answers(seam, target_, tracesOf("")), plain);
  EXPECT_NE(answers(seam, target_, tracesOf("tiled")), plain);
  LosesATile loses(*device_);
  EXPECT_EQ(answers(loses, target_, tracesOf("")), plain);
  EXPECT_NE(answers(loses, target_, tracesOf("tiled")), plain);
}

TEST(Variants, TheTilesCoverTheViewportOnce) {
  for (const Rect& viewport : {Rect{0, 0, 67, 41}, Rect{5, 3, 2, 1}, Rect{1, 1, 1, 1}}) {
    std::map<std::pair<int, int>, int> covered;
    for (const Rect& tile : tilesOf(viewport, 3, 2)) {
      for (int y = tile.y; y < tile.y + tile.height; ++y) {
        for (int x = tile.x; x < tile.x + tile.width; ++x) {
          ++covered[{x, y}];
        }
      }
    }
    EXPECT_EQ(covered.size(), static_cast<std::size_t>(viewport.width) * viewport.height);
    EXPECT_TRUE(std::ranges::all_of(covered, [&](const auto& texel) {
      const auto [x, y] = texel.first;
      return texel.second == 1 && x >= viewport.x && x < viewport.x + viewport.width && y >= viewport.y &&
             y < viewport.y + viewport.height;
    }));
  }
}

TEST(Variants, AnUnknownNameIsRefusedWithTheNearest) {
  const auto found = findVariant("tilled");
  ASSERT_FALSE(found.has_value());
  EXPECT_NE(sentence(found.error()).find("did you mean 'tiled'?"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Devices, VariantsTest, testing::Values("gl-osmesa", "vk-lavapipe"), deviceTestName);

}  // namespace
}  // namespace ssrkit
