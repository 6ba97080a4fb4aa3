// Whole rough reflections, sample by sample, against integrals in double precision: M1's floor made rough
// before its wall, where Oracle A knows what a ray meets.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "../statistics.h"
#include "frame/gbuffer_source.h"
#include "frame/run_job.h"
#include "frame/techniques.h"
#include "frame/tracing.h"
#include "ggx_reference.h"
#include "oracle/oracle.h"
#include "pass_test.h"

namespace ssrkit {
namespace {

constexpr int kSide = 64;
constexpr Size kSize{kSide, kSide};
constexpr int kFirstFloorRow = 40;
constexpr double kRoughness = 0.3125;  // exact in the G-buffer's half precision
constexpr double kWallDistance = 8.0;
const glm::dvec3 kHorizon{0.5, 0.5, 0.5};
const glm::dvec3 kZenith{0.25, 0.25, 0.25};

const Camera& camera() {
  static const Camera the_camera{.size = kSize,
                                 .clip_from_view = perspective(2.0 * std::atan(0.5), 1.0, 0.1, 100.0),
                                 .view_from_world = glm::dmat4(1.0),
                                 .near_m = 0.1,
                                 .far_m = 100.0};
  return the_camera;
}

bool isFloor(int y) {
  return y >= kFirstFloorRow;
}

double distAt(int y) {
  return isFloor(y) ? 2.0 / ((y + 0.5) / (kSide / 2) - 1.0) : kWallDistance;
}

glm::dvec3 pointAt(int x, int y) {
  const PixelProjection projection = pixelProjection(camera());
  const glm::dvec2 slope = (glm::dvec2(x + 0.5, y + 0.5) - projection.px_offset) / projection.px_scale;
  return distAt(y) * glm::dvec3(slope, -1.0);
}

// A wall that is bright on its right half; the floor's own light is never seen in the floor.
double litAt(int x) {
  return x < kSide / 2 ? 0.125 : 1.0;
}

std::map<std::string, Image> gbufferOf(double roughness) {
  std::map<std::string, Image> images;
  images["dist_view"] = imageOf(
      kSize,
      [](int, int y) {
        return std::array{distAt(y), 0.0, 0.0, 0.0};
      },
      1);
  images["normal_view"] = imageOf(kSize, [](int, int y) {
    return isFloor(y) ? std::array{0.0, 1.0, 0.0, 1.0} : std::array{0.0, 0.0, 1.0, 1.0};
  });
  images["material"] = imageOf(
      kSize,
      [&](int, int y) {
        return std::array{1.0, roughness, isFloor(y) ? 1.0 : 0.0, 0.0};
      },
      3);
  images["albedo"] = imageOf(
      kSize,
      [](int, int) {
        return std::array{1.0, 1.0, 1.0, 1.0};
      },
      3);
  images["lit"] = imageOf(
      kSize,
      [](int x, int y) {
        const double lit = isFloor(y) ? 0.0 : litAt(x);
        return std::array{lit, lit, lit, 1.0};
      },
      3);
  return images;
}

struct Floor {
  int x;
  int y;
  double mean;
  double variance;  // of one sample
};

// The floor's frame with the eye over its x axis, and the direction to the eye.
struct Place {
  glm::dvec3 along;
  glm::dvec3 aside;
  glm::dvec3 to_eye;
  [[nodiscard]] GgxView view() const { return {.cosine = to_eye.y, .roughness = kRoughness}; }
  [[nodiscard]] glm::dvec3 inView(const glm::dvec3& d) const {
    return d.x * along + d.y * aside + d.z * glm::dvec3(0, 1, 0);
  }
};

Place placeAt(int x, int y) {
  const glm::dvec3 to_eye = -glm::normalize(pointAt(x, y));
  const glm::dvec3 along = glm::normalize(to_eye - to_eye.y * glm::dvec3(0, 1, 0));
  return {.along = along, .aside = glm::cross(glm::dvec3(0, 1, 0), along), .to_eye = to_eye};
}

// The lit texel hit, else the sky's gradient, by the horizon's square root.
double radianceOf(const RayHit& hit, const glm::dvec3& direction) {
  return hit.ray_class == RayClass::kHit && !isFloor(hit.texel_y) ? litAt(hit.texel_x)
         : hit.ray_class == RayClass::kHit
             ? 0.0
             : glm::mix(kHorizon.x, kZenith.x, std::sqrt(std::max(direction.y, 0.0)));
}

// The integrals of some floor pixels, by quadrature over their microfacets, each of which Oracle A traces.
std::vector<Floor> integrate() {
  constexpr int kRises = 96;
  constexpr int kTurns = 48;
  auto images = gbufferOf(kRoughness);
  Image& normals = images.at("normal_view");
  Image mask(kSize, {"B"});
  std::vector<Floor> pixels;
  for (int y = kFirstFloorRow; y < kSide; y += 3) {
    for (int x = 2; x < kSide; x += 4) {
      pixels.push_back({x, y, 0.0, 0.0});
      mask.at(x, y) = 1.0F;
    }
  }
  for (int node = 0; node < kRises * kTurns; ++node) {
    std::vector<VisibleFacet> facets;
    for (const Floor& pixel : pixels) {
      const Place place = placeAt(pixel.x, pixel.y);
      facets.push_back(
          visibleFacet(place.view(), 1.0, (node / kTurns + 0.5) / kRises, (node % kTurns + 0.5) / kTurns));
      const glm::vec3 normal(place.inView(facets.back().direction));
      std::copy_n(&normal.x, 3, &normals.at(pixel.x, pixel.y));
    }
    const auto traced = traceOracle({.camera = &camera(),
                                     .dist_view = &images.at("dist_view"),
                                     .normal_view = &normals,
                                     .mask = &mask,
                                     .parameters = {}},
                                    1);
    SSRKIT_CHECK(traced.has_value());
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const Place place = placeAt(pixels[i].x, pixels[i].y);
      const glm::dvec3 reflected = glm::reflect(-place.to_eye, place.inView(facets[i].direction));
      const double sample =
          facets[i].weight * radianceOf(traced->record.at(pixels[i].x, pixels[i].y), reflected);
      pixels[i].mean += facets[i].density * sample / (kRises * kTurns);
      pixels[i].variance += facets[i].density * sample * sample / (kRises * kTurns);
    }
  }
  for (Floor& pixel : pixels) {
    pixel.variance -= pixel.mean * pixel.mean;
  }
  return pixels;
}

const std::vector<Floor>& floorPixels() {
  static const std::vector<Floor> pixels = integrate();
  return pixels;
}

class RoughTracingTest : public PassTest {
 protected:
  void SetUp() override {
    PassTest::SetUp();
    settings_.shader_root = std::string(SSRKIT_SOURCE_DIR) + "/shaders";
    programs_.emplace(*device_, target_);
    images_.emplace(*device_, kSize);
    auto gbuffer = gbufferOf(kRoughness);
    ASSERT_TRUE(uploadGbuffer(*device_, gbuffer, *images_).has_value());
    ASSERT_TRUE(uploadImage(*device_, **images_->get("lit"), gbuffer["lit"], {0, 0, 0, 1}).has_value());
    setCameraUniforms(values_, camera());
    values_.set("up_view", glm::dvec3(0, 1, 0));
    values_.set("sky_horizon", kHorizon);
    values_.set("sky_zenith", kZenith);
    for (const auto* name : {"thickness_m", "max_distance_m"}) {
      values_.set(name, 1e30);
    }
    for (const auto* name : {"thickness_rel", "origin_bias", "step_m", "stride_px", "jitter"}) {
      values_.set(name, 0.0);
    }
    for (const auto* name : {"step_count", "bisection_count", "max_mip"}) {
      values_.set(name, 0);
    }
    values_.set("lookup_budget", 60000);
  }

  // A technique's passes with as many samples as a test wants; the means after `counts` samples.
  std::map<int, Image> means(const std::string& technique, int sample_count, const std::vector<int>& counts);

  void replace(const std::string& shader) {
    const std::filesystem::path file(shader);
    settings_.replacements.clear();
    if (file.is_absolute()) {
      settings_.replacements[replaced_pass_] = file;
    }
  }
  std::string replaced_pass_;
  CompileSettings settings_;

 private:
  void drawAll(const std::vector<FramePass>& passes);
  std::optional<Programs> programs_;
  std::optional<FrameImages> images_;
};

void RoughTracingTest::drawAll(const std::vector<FramePass>& passes) {
  const auto prepared = preparePasses(*programs_, settings_, passes, [](const std::string&) {});
  ASSERT_TRUE(prepared.has_value()) << sentence(prepared.error());
  for (const PreparedPass& pass : *prepared) {
    const auto time = drawPass(*device_, pass, *images_, values_);
    ASSERT_TRUE(time.has_value()) << sentence(time.error());
  }
}

std::map<int, Image> RoughTracingTest::means(const std::string& technique, int sample_count,
                                             const std::vector<int>& counts) {
  const auto row = findTechnique(technique);
  EXPECT_TRUE(row.has_value());
  FramePass trace = tracePass("trace_walk.frag");
  trace.inputs = (*row)->trace_inputs;
  std::vector<FramePass> each = (*row)->before_trace;
  each.push_back(trace);
  each.insert(each.end(), (*row)->after_sample.begin(), (*row)->after_sample.end());
  std::map<int, Image> read;
  for (int sample = 0; sample < sample_count; ++sample) {
    values_.set("sample_index", sample);
    values_.set("sample_count", sample_count);
    drawAll(each);
    if (std::ranges::find(counts, sample + 1) != counts.end()) {
      values_.set("sample_count", sample + 1);
      drawAll({(*row)->after_trace.front()});
      auto image = readImage(*device_, *images_->find("reflection"), {"R", "G", "B", "A"});
      EXPECT_TRUE(image.has_value());
      read[sample + 1] = *image;
    }
  }
  return read;
}

double meanSquaredError(const Image& reflection) {
  double sum = 0.0;
  for (const Floor& pixel : floorPixels()) {
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
  replaced_pass_ = "average_samples";
  constexpr int kSamples = 1024;
  const auto check = [&](const std::string& shader) -> std::string {
    replace(shader);
    const Image mean = means("ggx_16_white", kSamples, {kSamples}).at(kSamples);
    double squares = 0.0;
    double worst = 0.0;
    double count = 0.0;
    for (const Floor& pixel : floorPixels()) {
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
  replaced_pass_ = "sample_microfacet";
  const auto check = [&](const std::string& shader) -> std::string {
    replace(shader);
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
    for (int x = 16; x < kSide / 2; ++x) {
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
  job.size = kSize;
  job.shader_root = settings_.shader_root;
  job.gbuffer_camera = camera();
  job.gbuffer = gbufferOf(0.0);
  for (const std::string technique : {"mirror", "jittered_1", "jittered_16", "ggx_1", "ggx_16"}) {
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
