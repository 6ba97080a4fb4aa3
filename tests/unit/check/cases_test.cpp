#include <gtest/gtest.h>

#include <cmath>

#include "made_answers.h"
#include "oracle/image_ray.h"

namespace ssrkit {
namespace {

const std::string kCases =
    "[[case]]\nname = \"a\"\nstep_m = 0.4\n[[case]]\nname = \"b\"\nstep_m = 0.2\n"
    "[[case]]\nname = \"c\"\nstep_m = 0.1\n";

// Three cases with half the step each. The oracle hits every ray 1 m along it; the case's hits lie `errors`
// metres further on.
Bench converging(const std::vector<double>& steps_m, const std::vector<double>& errors_m) {
  Bench bench;
  for (std::size_t i = 0; i < steps_m.size(); ++i) {
    Answer& answer =
        bench.add("hiz", shiftedRecord(kMadeSize), "gl-osmesa", std::string(1, static_cast<char>('a' + i)));
    answer.parameters.step_m = steps_m[i];
    bench.setOracle(answer, shiftedRecord(kMadeSize));
    OracleInput& input = bench.setWorld(answer, 4.0F);
    const PixelProjection projection = pixelProjection(*input.camera);
    for (int y = 0; y < kMadeSize.height; ++y) {
      for (int x = 0; x < kMadeSize.width; ++x) {
        const ImageRay ray = pixelRay(input, projection, x, y).ray;
        const auto put = [&](RayHit& hit, double t_m) {
          const glm::dvec2 px = ray.pxAt(t_m * ray.inv_dist_origin / (1.0 - t_m * ray.inv_dist_per_sigma));
          hit.px_x = static_cast<float>(px.x);
          hit.px_y = static_cast<float>(px.y);
          hit.t_m = static_cast<float>(t_m);
        };
        const auto index = static_cast<std::size_t>(y) * kMadeSize.width + static_cast<std::size_t>(x);
        put(bench.oracles.back().record.rays[index], 1.0);
        put(bench.records.back().rays[index], 1.0 + errors_m[i]);
      }
    }
  }
  return bench;
}

Expectation convergence(const std::string& keys = "") {
  return expectation("metric = \"convergence\"\ncases = [\"a\", \"b\", \"c\"]\nmax = 1.0\n" + keys, kCases);
}

TEST(Convergence, ErrorsWithinTheProjectedStepThatFallPass) {
  const CheckResult result = converging({0.4, 0.2, 0.1}, {0.36, 0.18, 0.09}).check(convergence());
  EXPECT_EQ(outcomeName(result), "pass") << result.message;
  EXPECT_GT(*result.value, 0.8);
}

TEST(Convergence, AnErrorLongerThanItsStepFails) {
  EXPECT_EQ(outcomeName(converging({0.4, 0.2, 0.1}, {0.36, 0.18, 0.2}).check(convergence())), "fail");
  EXPECT_EQ(outcomeName(converging({0.4, 0.2, 0.1}, {0.9, 0.18, 0.09}).check(convergence())), "fail");
}

TEST(Convergence, AnErrorThatDoesNotFallFails) {
  const CheckResult result = converging({0.4, 0.2, 0.1}, {0.09, 0.09, 0.09}).check(convergence());
  EXPECT_EQ(outcomeName(result), "fail");
  EXPECT_NE(result.message.find("does not fall"), std::string::npos) << result.message;
}

TEST(Convergence, NoErrorNeedNotFall) {
  EXPECT_EQ(outcomeName(converging({0.4, 0.2, 0.1}, {0.0, 0.0, 0.0}).check(convergence())), "pass");
}

TEST(Convergence, BisectionsHalveTheStepThatIsAllowed) {
  Bench bench = converging({0.4, 0.4, 0.4}, {0.36, 0.18, 0.09});
  bench.answers[1].parameters.bisection_count = 1;
  bench.answers[2].parameters.bisection_count = 2;
  EXPECT_EQ(outcomeName(bench.check(convergence())), "pass");
  bench.answers[2].parameters.bisection_count = 3;
  EXPECT_EQ(outcomeName(bench.check(convergence())), "fail");
}

// The same with hits that lie pixels from the oracle's, after strides of pixels.
Bench strided(const std::vector<int>& strides_px, const std::vector<float>& errors_px) {
  Bench bench = converging({0.0, 0.0, 0.0}, {0.0, 0.0, 0.0});
  for (std::size_t i = 0; i < strides_px.size(); ++i) {
    bench.answers[i].parameters.stride_px = strides_px[i];
    for (RayHit& ray : bench.records[i].rays) {
      ray.px_x += errors_px[i];
    }
  }
  return bench;
}

TEST(Convergence, StridesAreMeasuredInPixels) {
  EXPECT_EQ(outcomeName(strided({8, 4, 1}, {7.0F, 3.0F, 0.9F}).check(convergence())), "pass");
  EXPECT_EQ(outcomeName(strided({8, 4, 1}, {7.0F, 3.0F, 1.6F}).check(convergence())), "fail");
  Bench bench = strided({8, 8, 8}, {7.0F, 1.8F, 0.45F});
  bench.answers[1].parameters.bisection_count = 2;
  bench.answers[2].parameters.bisection_count = 4;
  EXPECT_EQ(outcomeName(bench.check(convergence())), "pass");
}

TEST(Convergence, CasesWithoutAStepCannotBeMeasured) {
  EXPECT_EQ(outcomeName(strided({1, 1, 1}, {0.5F, 0.4F, 0.3F}).check(convergence())), "error");
}

TEST(Convergence, MissedHitsAreInfinitelyWrongUpToThePercentile) {
  Bench bench = converging({0.4, 0.2, 0.1}, {0.36, 0.18, 0.09});
  for (std::size_t i = 0; i < 6; ++i) {
    bench.records[2].rays[i] = without(RayClass::kRange);  // 6 of 64
  }
  EXPECT_EQ(outcomeName(bench.check(convergence())), "fail");
  EXPECT_EQ(outcomeName(bench.check(convergence("percentile = 90.0"))), "pass");
  EXPECT_EQ(outcomeName(bench.check(convergence("percentile = 91.0"))), "fail");
}

TEST(Convergence, ACaseThatDidNotRunIsAnError) {
  Bench bench = converging({0.4, 0.2}, {0.36, 0.18});
  EXPECT_EQ(outcomeName(bench.check(convergence())), "error");
}

// Budgets 2 and 5 on rays that need up to 3 lookups.
Bench budgets() {
  Bench bench;
  for (const int budget : {2, 5}) {
    RayRecord record = shiftedRecord(kMadeSize);
    if (budget == 2) {
      record.rays[0] = without(RayClass::kBudget, 2);
    }
    bench.add("hiz", record, "gl-osmesa", budget == 2 ? "a" : "b").parameters.lookup_budget = budget;
  }
  return bench;
}

TEST(BudgetMonotone, OnlyBudgetMayTurnIntoAnAnswer) {
  const Expectation monotone = expectation("metric = \"budget_monotone\"\ncases = [\"a\", \"b\"]", kCases);
  Bench bench = budgets();
  EXPECT_EQ(outcomeName(bench.check(monotone)), "pass");
  bench.records[1].rays[3].texel_x += 1;
  EXPECT_EQ(outcomeName(bench.check(monotone)), "fail");
  bench = budgets();
  bench.records[1].rays[3] = without(RayClass::kBudget);
  EXPECT_EQ(outcomeName(bench.check(monotone)), "fail");
  bench.answers[1].parameters.lookup_budget = 2;
  EXPECT_EQ(outcomeName(bench.check(monotone)), "error");
}

}  // namespace
}  // namespace ssrkit
