// Whole rough reflections, sample by sample, against integrals in double precision.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "../statistics.h"
#include "frame/run_job.h"
#include "rough_floor.h"
#include "rough_floor_test.h"

namespace ssrkit {
namespace {

class RoughTracingTest : public RoughFloorTest {};

const std::vector<FloorPixel>& floorPixels() {
  static const std::vector<FloorPixel> pixels = floorIntegrals([](int) { return kFloorRoughness; });
  return pixels;
}

double meanSquaredError(const Image& reflection) {
  double sum = 0.0;
  for (const FloorPixel& pixel : floorPixels()) {
    const double error = reflection.at(pixel.x, pixel.y) - pixel.mean;
    sum += error * error / static_cast<double>(floorPixels().size());
  }
  return sum;
}

// Of log error against log samples, from 4 samples on; the squares fall like a power of the count.
double convergence(const std::map<int, Image>& means) {
  std::vector<double> x;
  std::vector<double> y;
  for (const auto& [count, image] : means) {
    x.push_back(std::log2(count));
    y.push_back(std::log2(meanSquaredError(image)));
  }
  return slopeOf(x, y);
}

TEST_P(RoughTracingTest, EveryPixelsMeanIsItsIntegral) {
  constexpr int kSamples = 1024;
  const auto check = [&](const std::string& shader) -> std::string {
    replace("average_samples", shader);
    const Image mean = means("ggx_16_white", kSamples, {kSamples}).at(kSamples);
    double squares = 0.0;
    double worst = 0.0;
    double count = 0.0;
    for (const FloorPixel& pixel : floorPixels()) {
      // Rare bright samples are no normal variable yet: 30 hits of the rarer kind at least.
      if (pixel.variance * kSamples < 30.0 * 0.875 * 0.875) {
        continue;
      }
      const double z = (mean.at(pixel.x, pixel.y) - pixel.mean) / std::sqrt(pixel.variance / kSamples);
      squares += z * z;
      worst = std::max(worst, std::abs(z));
      count += 1.0;
    }
    const double p = std::min(twoSidedP(worst) * count, chiSquaredP(squares, count));
    return count > 60.0 && p >= kFamilyLevel
               ? ""
               : fmt::format("{} pixels: worst z {:.2f}, mean square {:.3f}", count, worst, squares / count);
  };
  holdsAndKills(check, "average_samples.frag", {"sample_count_left_out"});
}

TEST_P(RoughTracingTest, TheVarianceFallsWithTheNumberOfSamples) {
  const auto check = [&](const std::string& shader) -> std::string {
    replace("sample_microfacet", shader);
    const double slope = convergence(means("ggx_16_white", 256, {4, 16, 64, 256}));
    return std::abs(slope + 1.0) < 0.1 ? "" : fmt::format("the slope is {:.3f}, not -1", slope);
  };
  holdsAndKills(check, "sample_microfacet.frag", {"same_sample_again"});
}

TEST_P(RoughTracingTest, SpreadPointsConvergeFasterThanIndependentOnes) {
  std::map<int, Image> spread;
  for (const int count : {4, 16, 64}) {
    spread.merge(means("ggx_16", count, {count}));
  }
  const double independent = meanSquaredError(means("ggx_16_white", 16, {16}).at(16));
  EXPECT_LT(convergence(spread), -1.2);
  EXPECT_LT(meanSquaredError(spread.at(16)), 0.5 * independent);
}

TEST_P(RoughTracingTest, AReflectionIsSharpWhereItTouchesAndWidensAwayFromIt) {
  const Image mean = means("ggx_16", 256, {256}).at(256);
  double narrower = 0.0;
  for (const int row : {40, 43, 48, 54, 60}) {
    // How much of the wall's step leaks to the other side, in columns of its height.
    double leaked = 0.0;
    for (int x = 16; x < kFloorSize.width / 2; ++x) {
      leaked += (mean.at(x, row) - mean.at(8, row)) / (mean.at(56, row) - mean.at(8, row));
    }
    EXPECT_GT(leaked, narrower) << row;
    narrower = leaked;
    if (row == kFirstFloorRow) {
      EXPECT_LT(leaked, 0.5);
    }
  }
}

TEST_P(RoughTracingTest, AMirrorKeepsThePlainTechniquesBits) {
  Job job;
  job.id = "rough m1";
  job.size = kFloorSize;
  job.shader_root = settings_.shader_root;
  job.gbuffer_camera = floorCamera();
  job.gbuffer = floorGbuffer([](int) { return 0.0; });
  for (const std::string technique :
       {"mirror", "jittered_1", "jittered_16", "ggx_1", "ggx_16", "stochastic"}) {
    job.traces.push_back({.stage = "hiz", .parameters = {}, .technique = technique});
  }
  const auto result = JobRunner(*device_, target_).run(job, [](const std::string&) {});
  ASSERT_TRUE(result.has_value()) << sentence(result.error());
  const TraceResult& plain = result->traces.front();
  for (const TraceResult& rough : result->traces) {
    for (std::size_t ray = 0; ray < plain.record.rays.size(); ++ray) {
      ASSERT_EQ(rough.record.rays[ray].texel_y, plain.record.rays[ray].texel_y) << rough.technique;
      ASSERT_EQ(rough.record.rays[ray].ray_class, plain.record.rays[ray].ray_class) << rough.technique;
      ASSERT_EQ(rough.record.rays[ray].t_m, plain.record.rays[ray].t_m) << rough.technique;
    }
    EXPECT_EQ(rough.images.at("composite").data, plain.images.at("composite").data) << rough.technique;
  }
}

INSTANTIATE_TEST_SUITE_P(Each, RoughTracingTest, testing::Values("gl-osmesa", "vk-lavapipe"), deviceTestName);

}  // namespace
}  // namespace ssrkit
