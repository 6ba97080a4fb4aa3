// The same job asked in another way gives the same bits, on each device; and what a wrong driver would do to
// a variant is seen.
#include "frame/variants.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

#include "device/forwarding_device.h"
#include "frame/run_job.h"
#include "frame/tiled_device.h"
#include "frame_device.h"
#include "made_gbuffers.h"

namespace ssrkit {
namespace {

constexpr Size kSize{67, 41};  // tiles and quads do not fit

Job tracesOf(const std::string& variant) {
  Job job = randomBlocks(kSize);
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

// Takes the scissor for the viewport: what is drawn into a tile is the whole picture, made small.
class TilesForViewports final : public ForwardingDevice {
 public:
  using ForwardingDevice::ForwardingDevice;
  [[nodiscard]] Expected<PassTime> draw(const PassDesc& pass) override {
    PassDesc wrong = pass;
    wrong.viewport = pass.scissor.value_or(pass.viewport);
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
    EXPECT_EQ(answers(*device_, target_, tracesOf(variant.name)), plain) << variant.name;
  }
}

TEST_P(VariantsTest, TilesShowADeviceThatConfusesScissorAndViewport) {
  const auto plain = answers(*device_, target_, tracesOf(""));
  TilesForViewports moves(*device_);
  EXPECT_EQ(answers(moves, target_, tracesOf("")), plain);
  EXPECT_NE(answers(moves, target_, tracesOf("tiled")), plain);
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
