// Stochastic SSR: which rays are traced, what neighbours' rays count for, what the filter leaves.
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

class RoughFilterTest : public PassTest {
 protected:
  static constexpr Size kSize{48, 48};

  // A plane that faces the eye 4 m away, of one roughness.
  void SetUp() override {
    PassTest::SetUp();
    begin();
    values_.set("size_px", glm::dvec2(48.0));
    values_.set("texel_uv", glm::dvec2(1.0 / 48.0));
    values_.set("px_offset", glm::dvec2(24.0));
    values_.set("view_per_px", glm::dvec2(1.0 / 48.0, -1.0 / 48.0));
    values_.set("spacing_px", 1);
    surface([](int) { return Surface{}; });
  }

  struct Surface {
    double dist = 4.0;
    glm::dvec3 normal{0.0, 0.0, 1.0};
    double roughness = 0.25;
    double mask = 1.0;
  };
  void surface(const std::function<Surface(int x)>& at) {
    give("dist_view", imageOf(
                          kSize,
                          [&](int x, int) {
                            return std::array{at(x).dist, 0.0, 0.0, 0.0};
                          },
                          1));
    give("normal_view", imageOf(kSize, [&](int x, int) {
           return std::array{at(x).normal.x, at(x).normal.y, at(x).normal.z, 1.0};
         }));
    give("material", imageOf(kSize, [&](int x, int) {
           return std::array{1.0, at(x).roughness, at(x).mask, 0.0};
         }));
  }
  void radiance(const std::function<double(int x)>& at, double variance) {
    give("unfiltered", imageOf(kSize, [&](int x, int) { return std::array{at(x), at(x), at(x), 1.0}; }));
    give("unfiltered_variance", imageOf(
                                    kSize,
                                    [&](int, int) {
                                      return std::array{variance, 0.0, 0.0, 0.0};
                                    },
                                    1));
  }
};

TEST_P(RoughFilterTest, AConstantKeepsItsBits) {
  radiance([](int) { return 0.3; }, 0.01);
  const Image filtered = draw("filter_reflection.frag", kSize);
  for (const float value : std::vector(filtered.data.begin(), filtered.data.begin() + 3)) {
    EXPECT_EQ(value, 0.3F);
  }
  EXPECT_EQ(difference(filtered,
                       imageOf(kSize,
                               [](int, int) {
                                 return std::array{0.3, 0.3, 0.3, 1.0};
                               }),
                       0.0),
            "");
}

TEST_P(RoughFilterTest, NoiseOfItsOwnVarianceIsAveraged) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal(0.5, 0.1);
  give("unfiltered", imageOf(kSize, [&](int, int) {
         const double value = normal(random);
         return std::array{value, value, value, 1.0};
       }));
  give("unfiltered_variance", imageOf(
                                  kSize,
                                  [](int, int) {
                                    return std::array{0.01, 0.0, 0.0, 0.0};
                                  },
                                  1));
  const Image filtered = draw("filter_reflection.frag", kSize);
  double squares = 0.0;
  for (std::size_t texel = 0; texel < filtered.texelCount(); ++texel) {
    squares += std::pow(filtered.data[4 * texel] - 0.5, 2.0) / static_cast<double>(filtered.texelCount());
  }
  // The binomial's own factor is 9 / 64 = 0.14; the weights by luminance take some of it back.
  EXPECT_LT(squares, 0.20 * 0.01);
}

TEST_P(RoughFilterTest, WithoutVarianceAStepStays) {
  radiance([](int x) { return x < 24 ? 0.25 : 0.75; }, 0.0);
  const Image filtered = draw("filter_reflection.frag", kSize);
  EXPECT_EQ(difference(filtered,
                       imageOf(kSize,
                               [](int x, int) {
                                 const double value = x < 24 ? 0.25 : 0.75;
                                 return std::array{value, value, value, 1.0};
                               }),
                       0.0),
            "");
}

TEST_P(RoughFilterTest, NothingRunsAcrossTheEdgesOfASurface) {
  const auto left = [](int x) { return x < 24; };
  const std::vector<std::function<Surface(int)>> edges = {
      [&](int x) { return Surface{.dist = left(x) ? 4.0 : 5.0}; },
      [&](int x) { return Surface{.normal = left(x) ? glm::dvec3(0, 0, 1) : glm::dvec3(0.8, 0, 0.6)}; },
      [&](int x) { return Surface{.roughness = left(x) ? 0.25 : 0.5}; },
      [&](int x) { return Surface{.mask = left(x) ? 1.0 : 0.0}; }};
  for (const auto& edge : edges) {
    surface(edge);
    radiance([&](int x) { return left(x) ? 0.25 : 0.75; }, 100.0);
    const Image filtered = draw("filter_reflection.frag", kSize);
    EXPECT_EQ(difference(filtered,
                         imageOf(kSize,
                                 [&](int x, int) {
                                   const double value = left(x) ? 0.25 : 0.75;
                                   return std::array{value, value, value, 1.0};
                                 }),
                         1e-5),
              "");
  }
}

INSTANTIATE_TEST_SUITE_P(Each, RoughStochasticTest, testing::Values("gl-osmesa", "vk-lavapipe"),
                         deviceTestName);
INSTANTIATE_TEST_SUITE_P(Each, RoughFilterTest, testing::Values("gl-osmesa", "vk-lavapipe"), deviceTestName);

}  // namespace
}  // namespace ssrkit
