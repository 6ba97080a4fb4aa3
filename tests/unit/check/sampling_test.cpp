// How a march spends its samples, in the scene m1: there the texel of every sample is a formula
// (docs/spaces.md).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "check/march_samples.h"
#include "made_answers.h"

namespace ssrkit {
namespace {

// m1 of 256 x 256 texels: f = 2, a level camera 1 m above a mirror floor, which goes on for ever here.
constexpr int kSide = 256;
constexpr double kFocal = 2.0;
constexpr double kHeight = 1.0;
constexpr int kFirstFloorRow = 160;  // so near that a ray of 10 m stays below its vanishing point

double ndcY(int row) {
  return 1.0 - (row + 0.5) / (0.5 * kSide);
}

// dist_view of the floor seen in this row.
double floorDist(int row) {
  return kHeight * kFocal / -ndcY(row);
}

// Metres along the ray for each metre of dist_view, for the column's x.
double metresPerDist(int x, int row) {
  const double ndc_x = (x + 0.5) / (0.5 * kSide) - 1.0;
  return std::sqrt(1.0 + (ndc_x * ndc_x + ndcY(row) * ndcY(row)) / (kFocal * kFocal));
}

// The row in which the ray of (x, row) is after t_m metres: it is seen at |Y| - 2hf / dist_view.
int rowAfter(int x, int row, double t_m) {
  const double dist = floorDist(row) + t_m / metresPerDist(x, row);
  const double ndc = -ndcY(row) - 2.0 * kHeight * kFocal / dist;
  return static_cast<int>(std::floor((1.0 - ndc) * 0.5 * kSide));
}

Camera m1Camera() {
  Camera camera = squareCamera({kSide, kSide});
  camera.clip_from_view = perspective(2.0 * std::atan(1.0 / kFocal), 1.0, 0.1, 100.0);
  return camera;
}

struct World {
  Camera camera = m1Camera();
  Image dist_view{{kSide, kSide}, {"dist_view"}};
  Image normal_view{{kSide, kSide}, {"x", "y", "z"}};
  OracleInput input;
  Bench bench;

  World() {
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        dist_view.at(x, y) =
            y >= kFirstFloorRow ? static_cast<float>(floorDist(y)) : std::numeric_limits<float>::infinity();
        normal_view.at(x, y, 1) = 1.0F;
      }
    }
    input.camera = &camera;
    input.dist_view = &dist_view;
    input.normal_view = &normal_view;
  }

  // An answer whose rays each took what `ray` says of (x, row).
  Answer& add(const std::string& stage, const TraceParameters& parameters,
              const std::function<RayHit(int x, int row)>& ray) {
    RayRecord record{{kSide, kSide}, {}};
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        record.rays.push_back(y < kFirstFloorRow ? without(RayClass::kBackground, 0) : ray(x, y));
      }
    }
    Answer& answer = bench.add(stage, std::move(record));
    answer.parameters = parameters;
    input.parameters = parameters;
    answer.oracle_input = &input;
    return answer;
  }
};

RayHit missAfter(std::uint32_t steps) {
  RayHit hit = without(RayClass::kRange, steps);
  hit.steps = steps;
  return hit;
}

constexpr int kMarchSteps = 40;
constexpr double kStepM = 0.25;

TraceParameters marchParameters() {
  TraceParameters parameters;
  parameters.max_distance_m = 20.0;
  parameters.step_m = kStepM;
  return parameters;
}

TEST(Sampling, OfEvenStepsInSpaceIsTheFormulas) {
  World world;
  world.add("naive", marchParameters(), [](int, int) { return missAfter(kMarchSteps); });
  std::size_t again = 0;
  std::size_t skipped = 0;
  std::size_t moved = 0;
  for (int row = kFirstFloorRow; row < kSide; ++row) {
    for (int x = 0; x < kSide; ++x) {
      int before = row;
      for (int i = 1; i <= kMarchSteps; ++i) {
        const int now = rowAfter(x, row, i * kStepM);
        again += now == before ? 1U : 0U;
        moved += static_cast<std::size_t>(before - now);
        skipped += static_cast<std::size_t>(std::max(0, before - now - 1));
        before = now;
      }
    }
  }
  const auto samples = static_cast<double>((kSide - kFirstFloorRow) * kSide * kMarchSteps);
  const CheckResult again_check =
      world.bench.check(expectation("metric = \"resampled_share\"\nmax = 0.0001"));
  EXPECT_DOUBLE_EQ(again_check.value.value_or(-1.0), static_cast<double>(again) / samples);
  EXPECT_GT(*again_check.value, 0.04);  // far away samples fall into one texel ...
  EXPECT_EQ(outcomeName(again_check), "fail");
  const CheckResult skipped_check =
      world.bench.check(expectation("metric = \"skipped_share\"\nmax = 0.0001"));
  EXPECT_DOUBLE_EQ(skipped_check.value.value_or(-1.0),
                   static_cast<double>(skipped) / static_cast<double>(moved));
  EXPECT_GT(*skipped_check.value, 0.5);  // ... and nearby they jump
  EXPECT_EQ(outcomeName(skipped_check), "fail");
}

TEST(Sampling, TheHistogramCountsEverySampleByItsMove) {
  World world;
  world.add("naive", marchParameters(), [](int, int) { return missAfter(kMarchSteps); });
  std::map<std::string, std::size_t> expected;
  for (int row = kFirstFloorRow; row < kSide; ++row) {
    for (int x = 0; x < kSide; ++x) {
      for (int i = 1; i <= kMarchSteps; ++i) {
        const int moved = rowAfter(x, row, (i - 1) * kStepM) - rowAfter(x, row, i * kStepM);
        ++expected[moved == 0    ? "again"
                   : moved == 1  ? "1 on"
                   : moved == 2  ? "2 on"
                   : moved <= 4  ? "3 to 4 on"
                   : moved <= 8  ? "5 to 8 on"
                   : moved <= 16 ? "9 to 16 on"
                                 : "17 or more on"];
      }
    }
  }
  const CheckResult check = world.bench.check(expectation("metric = \"resampled_share\"\nmax = 1"));
  ASSERT_EQ(check.histogram.size(), 7U);
  for (const HistogramBin& bin : check.histogram) {
    EXPECT_EQ(bin.count, expected[bin.label]) << bin.label;
  }
}

TEST(Sampling, OfColumnsNeitherRepeatsNorSkips) {
  World world;
  world.add("dda", {}, [](int, int) { return missAfter(60); });
  const CheckResult again = world.bench.check(expectation("metric = \"resampled_share\"\nmax = 0"));
  EXPECT_EQ(outcomeName(again), "pass");
  const CheckResult skipped = world.bench.check(expectation("metric = \"skipped_share\"\nmax = 0"));
  EXPECT_EQ(outcomeName(skipped), "pass");
  EXPECT_EQ(again.histogram.at(1).count, again.compared * 60U);
}

TEST(Sampling, AStrideOfNTexelsSkipsAllButOneOfN) {
  World world;
  TraceParameters parameters;
  parameters.stride_px = 8;
  // 64 rows: the shortest ray has 65 to its vanishing point.
  world.add("dda", parameters, [](int, int) { return missAfter(8); });
  const CheckResult check = world.bench.check(expectation("metric = \"skipped_share\"\nmax = 1"));
  EXPECT_NEAR(check.value.value_or(0.0), 7.0 / 8.0, 1e-12);
}

TEST(Sampling, BisectionsOfAHitAreNoSamples) {
  World world;
  TraceParameters parameters = marchParameters();
  parameters.bisection_count = 8;
  world.add("refined", parameters, [](int x, int row) {
    RayHit hit = hitAt(x, rowAfter(x, row, 5 * kStepM));
    hit.steps = 5 + 8;
    return hit;
  });
  const CheckResult check = world.bench.check(expectation("metric = \"resampled_share\"\nmax = 1"));
  std::size_t samples = 0;
  for (const HistogramBin& bin : check.histogram) {
    samples += bin.count;
  }
  EXPECT_EQ(samples, check.compared * 5U);
}

TEST(Sampling, AShaderThatStepsOtherwiseIsFoundOut) {
  World world;
  world.add("naive", marchParameters(), [](int x, int row) {
    RayHit hit = hitAt(x, rowAfter(x, row, 5 * kStepM) - 3);  // three texels beyond its last sample
    hit.steps = 5;
    return hit;
  });
  const CheckResult check = world.bench.check(expectation("metric = \"resampled_share\"\nmax = 1"));
  EXPECT_EQ(outcomeName(check), "error");
  EXPECT_NE(check.message.find("steps otherwise than the contract says"), std::string::npos) << check.message;
}

TEST(Sampling, IsNotKnownOfAPyramidOrOfJitter) {
  World world;
  world.add("hiz", {}, [](int, int) { return missAfter(3); });
  EXPECT_EQ(outcomeName(world.bench.check(expectation("metric = \"resampled_share\"\nmax = 1"))), "error");
  World jittered;
  TraceParameters parameters;
  parameters.jitter = 1.0;
  jittered.add("dda", parameters, [](int, int) { return missAfter(3); });
  EXPECT_EQ(outcomeName(jittered.bench.check(expectation("metric = \"resampled_share\"\nmax = 1"))), "error");
}

}  // namespace
}  // namespace ssrkit
