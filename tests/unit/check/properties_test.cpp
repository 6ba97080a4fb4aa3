#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "made_answers.h"
#include "not_finite.h"

namespace ssrkit {
namespace {

// The outcome of a property on a sound record in which one ray was changed.
std::string withRay(const std::string& metric, const std::function<void(RayHit&)>& change) {
  Bench bench;
  bench.add("hiz", shiftedRecord(kMadeSize)).parameters.lookup_budget = 10;
  change(bench.records.front().rays[9]);  // of the pixel (1, 1), which hits (1, 5)
  return outcomeName(bench.check(expectation("metric = \"" + metric + "\"")));
}

void unchanged(RayHit& /*ray*/) {}

TEST(Properties, ASoundRecordHasThemAll) {
  for (const char* metric : {"finite", "no_self_hit", "hit_point_in_texel", "inside_image",
                             "lookups_within_budget", "class_consistent"}) {
    EXPECT_EQ(withRay(metric, unchanged), "pass") << metric;
  }
}

TEST(Properties, PositionsAndDistancesAreFinite) {
  EXPECT_EQ(withRay("finite", [](RayHit& ray) { ray.px_y = kNaN; }), "fail");
  EXPECT_EQ(withRay("finite", [](RayHit& ray) { ray.t_m = kInfinity; }), "fail");
  EXPECT_EQ(withRay("finite", [](RayHit& ray) { ray.t_m = -0.5F; }), "fail");
}

TEST(Properties, NoRayHitsItsOwnTexel) {
  EXPECT_EQ(withRay("no_self_hit", [](RayHit& ray) { ray.texel_y = 1; }), "fail");
}

TEST(Properties, TheHitPointLiesInTheHitTexelUpToRounding) {
  EXPECT_EQ(withRay("hit_point_in_texel", [](RayHit& ray) { ray.px_x = 2.0078125F; }), "pass");
  EXPECT_EQ(withRay("hit_point_in_texel", [](RayHit& ray) { ray.px_x = 2.0079F; }), "fail");
  EXPECT_EQ(withRay("hit_point_in_texel", [](RayHit& ray) { ray.px_y = 4.99F; }), "fail");
  EXPECT_EQ(withRay("hit_point_in_texel", [](RayHit& ray) { ray.px_x = kNaN; }), "fail");
}

TEST(Properties, HitsLieInsideTheImage) {
  EXPECT_EQ(withRay("inside_image", [](RayHit& ray) { ray.texel_x = 8; }), "fail");
  EXPECT_EQ(withRay("inside_image", [](RayHit& ray) { ray.px_x = 8.0F; }), "pass");
  EXPECT_EQ(withRay("inside_image", [](RayHit& ray) { ray.px_x = 8.001F; }), "fail");
}

TEST(Properties, LookupsStayWithinTheBudget) {
  EXPECT_EQ(withRay("lookups_within_budget", [](RayHit& ray) { ray.lookups = 11; }), "fail");
}

TEST(Properties, AClassAndItsTexelAgree) {
  EXPECT_EQ(withRay("class_consistent", [](RayHit& ray) { ray.texel_x = -1; }), "fail");
  EXPECT_EQ(withRay("class_consistent", [](RayHit& ray) { ray.ray_class = RayClass::kRange; }), "fail");
  EXPECT_EQ(withRay("class_consistent", [](RayHit& ray) { ray = without(RayClass::kMasked); }), "pass");
  EXPECT_EQ(withRay("class_consistent",
                    [](RayHit& ray) {
                      ray = without(RayClass::kBackground);
                      ray.lookups = 1;
                    }),
            "fail");
}

TEST(Properties, AClassThatDoesNotExistIsToldByItsNumber) {
  for (const int number : {kRayClassCount, 200, kLastRayClassNumber}) {
    Bench bench;
    bench.add("hiz", shiftedRecord(kMadeSize));
    RayHit& ray = bench.records.front().rays[9];
    ray = without(RayClass::kIntoSurface);
    ray.ray_class = static_cast<RayClass>(number);
    const CheckResult result = bench.check(expectation("metric = \"class_consistent\""));
    EXPECT_EQ(outcomeName(result), "fail") << number;
    EXPECT_NE(result.message.find("class " + std::to_string(number)), std::string::npos) << result.message;
    EXPECT_NE(result.message.find("a class from 0 to 6"), std::string::npos) << result.message;
  }
}

TEST(Properties, ImagesAreFiniteButForTheBackgroundsDistance) {
  Bench bench;
  Answer& answer = bench.add("", shiftedRecord(kMadeSize));
  Image& depth = bench.setImage(answer, "dist_view", 3.0F);
  Image& lit = bench.setImage(bench.answers[0], "lit", 0.5F);
  const Expectation finite_depth = expectation("metric = \"finite\"\nbuffer = \"dist_view\"");
  const Expectation finite_lit = expectation("metric = \"finite\"\nbuffer = \"lit\"");
  depth.at(1, 1) = kInfinity;
  EXPECT_EQ(outcomeName(bench.check(finite_depth)), "pass");
  EXPECT_EQ(outcomeName(bench.check(finite_lit)), "pass");
  depth.at(1, 1) = -kInfinity;
  EXPECT_EQ(outcomeName(bench.check(finite_depth)), "fail");
  lit.at(1, 1) = kInfinity;
  EXPECT_EQ(outcomeName(bench.check(finite_lit)), "fail");
  EXPECT_EQ(outcomeName(bench.check(expectation("metric = \"finite\"\nbuffer = \"motion\""))), "error");
}

}  // namespace
}  // namespace ssrkit
