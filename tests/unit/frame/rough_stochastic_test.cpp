// Stochastic SSR: which rays are traced, and what neighbours' rays count for.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "frame/run_job.h"
#include "frame/trace_pass.h"
#include "ggx_reference.h"
#include "rough_floor.h"
#include "rough_floor_test.h"

namespace ssrkit {
namespace {

class RoughStochasticTest : public RoughFloorTest {
 protected:
  // The technique up to the pass that writes `image`.
  Image drawn(const std::string& image) {
    const auto row = findTechnique("stochastic");
    EXPECT_TRUE(row.has_value());
    std::vector<FramePass> passes = (*row)->before_trace;
    std::ranges::copy(tracePasses("trace_walk.frag", **row), std::back_inserter(passes));
    for (const FramePass& pass : (*row)->after_trace) {
      passes.push_back(pass);
      if (pass.outputs.front() == image) {
        break;
      }
    }
    drawAll(passes);
    return read(image);
  }
};

TEST_P(RoughStochasticTest, AWhiteFurnaceGivesTheDirectionalAlbedo) {
  auto gbuffer = floorGbuffer([](int) { return kFloorRoughness; });
  std::ranges::fill(gbuffer.at("lit").data, 1.0F);
  giveFloor(gbuffer);
  values_.set("sky_horizon", glm::dvec3(1.0));
  values_.set("sky_zenith", glm::dvec3(1.0));
  const Image reflection = drawn("reflection");
  double got = 0.0;
  double expected = 0.0;
  for (int y = kFirstFloorRow; y < kFloorSize.height; ++y) {
    for (int x = 0; x < kFloorSize.width; x += 4) {
      got += reflection.at(x, y);
      expected += directionalAlbedo({.cosine = floorCosine(x, y), .roughness = kFloorRoughness}, 1.0);
    }
  }
  EXPECT_NEAR(got / expected, 1.0, 0.01);
}

// Columns of a narrow and a wide lobe side by side, two of each.
double alternating(int x) {
  return x / 2 % 2 == 1 ? 0.125 : 0.5;
}

TEST_P(RoughStochasticTest, NeighboursRaysCountByTheLobeOfTheReceiver) {
  giveFloor(floorGbuffer(alternating));
  static const std::vector<FloorPixel> pixels = floorIntegrals(alternating);
  const auto check = [&](const std::string& shader) -> std::string {
    replace("reuse_rays", shader);
    const Image reflection = drawn("reflection_reused");
    double error = 0.0;
    double count = 0.0;
    for (const FloorPixel& pixel : pixels) {
      // Where the narrow lobe sees one side of the wall, and a wide lobe both.
      if (alternating(pixel.x) < 0.2 && std::abs(pixel.x - 32) > 6 && std::abs(pixel.x - 32) < 26) {
        error += std::abs(reflection.at(pixel.x, pixel.y) - pixel.mean);
        count += 1.0;
      }
    }
    return count > 20.0 && error / count < 0.025 ? "" : fmt::format("mean error {:.4f}", error / count);
  };
  holdsAndKills(check, "reuse_rays.frag", {"reuse_unweighed"});
}

TEST_P(RoughStochasticTest, SurfacesTooRoughForOneRayAreMasked) {
  Job job;
  job.id = "classes";
  job.size = kFloorSize;
  job.shader_root = settings_.shader_root;
  job.gbuffer_camera = floorCamera();
  job.gbuffer = floorGbuffer([](int x) { return x < 20 ? 0.0 : x < 40 ? 0.5 : 0.75; });
  job.traces = {{.stage = "hiz", .parameters = {}, .technique = "mirror"},
                {.stage = "hiz", .parameters = {}, .technique = "stochastic"}};
  const auto result = JobRunner(*device_, target_).run(job, [](const std::string&) {});
  ASSERT_TRUE(result.has_value()) << sentence(result.error());
  const TraceResult& mirror = result->traces[0];
  const TraceResult& stochastic = result->traces[1];
  for (int y = kFirstFloorRow; y < kFloorSize.height; ++y) {
    for (int x = 0; x < kFloorSize.width; ++x) {
      const RayHit& ray = stochastic.record.at(x, y);
      if (x < 20) {
        EXPECT_EQ(ray.texel_y, mirror.record.at(x, y).texel_y);
      } else if (x < 40) {
        EXPECT_NE(ray.ray_class, RayClass::kMasked);
      } else {
        EXPECT_EQ(ray.ray_class, RayClass::kMasked);
        EXPECT_EQ(ray.lookups, 0U);
        EXPECT_GT(stochastic.images.at("reflection").at(x, y), 0.0F);  // the sky's
      }
    }
  }
}

TEST_P(RoughStochasticTest, InTheFullFrameTheFloorFindsTheWall) {
  Job job;
  job.id = "full";
  job.size = kFloorSize;
  job.frame = "full";
  job.shader_root = settings_.shader_root;
  job.gbuffer_camera = floorCamera();
  job.gbuffer = floorGbuffer([](int x) { return x < 20 ? 0.0 : x < 40 ? 0.3125 : 0.75; });
  job.gbuffer["lit_base"] = job.gbuffer.at("lit");
  job.traces = {{.stage = "hiz", .parameters = {}, .technique = "replace_ggx_16"},
                {.stage = "hiz", .parameters = {}, .technique = "replace_stochastic"}};
  const auto result = JobRunner(*device_, target_).run(job, [](const std::string&) {});
  ASSERT_TRUE(result.has_value()) << sentence(result.error());
  for (const TraceResult& trace : result->traces) {
    double hits = 0.0;
    for (int x = 0; x < 40; ++x) {
      hits += trace.images.at("reflection").at(x, 50, 3);
    }
    EXPECT_GT(hits, 20.0) << trace.technique;
  }
}

INSTANTIATE_TEST_SUITE_P(Each, RoughStochasticTest, testing::Values("gl-osmesa", "vk-lavapipe"),
                         deviceTestName);

}  // namespace
}  // namespace ssrkit
