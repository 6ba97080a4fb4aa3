// What the oracle refuses, and that it says why.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "analytic_scene.h"
#include "base/error.h"

namespace ssrkit::testing {

namespace {

std::string refusal(const OracleInput& input) {
  const Expected<OracleResult> result = traceOracle(input, 1);
  return result ? std::string() : sentence(result.error());
}

void expectRefused(const OracleInput& input, const std::string& words) {
  EXPECT_NE(refusal(input).find(words), std::string::npos) << "got: " << refusal(input);
}

}  // namespace

TEST(OracleInput, SizesThatDoNotAgreeAreRefusedWithBothSizes) {
  AnalyticScene scene = flatScene({8, 6});
  scene.dist_view = Image({8, 5}, {"Z"});
  expectRefused(scene.input(), "dist_view is 8x5 and the camera is 8x6");
  scene = flatScene({8, 6});
  scene.normal_view = Image({7, 6}, {"X", "Y", "Z"});
  expectRefused(scene.input(), "normal_view is 7x6");
  scene = flatScene({8, 6});
  scene.mask = Image({1, 1}, {"m"});
  expectRefused(scene.input(), "mask is 1x1");
}

TEST(OracleInput, WrongNumbersOfChannelsAreRefused) {
  AnalyticScene scene = flatScene({8, 6});
  scene.normal_view = Image({8, 6}, {"X", "Y"});
  expectRefused(scene.input(), "normal_view has 2 channels");
  scene = flatScene({8, 6});
  scene.dist_view = Image({8, 6}, {"Z", "A"});
  expectRefused(scene.input(), "dist_view has 2 channels");
}

TEST(OracleInput, AnImageWithoutItsDataIsRefused) {
  AnalyticScene scene = flatScene({8, 6});
  scene.dist_view.data.pop_back();
  expectRefused(scene.input(), "holds 47 numbers");
}

TEST(OracleInput, ACameraThatCannotBeUsedIsRefused) {
  AnalyticScene scene = flatScene({8, 6});
  scene.camera.clip_from_view[0][0] = std::nan("");
  expectRefused(scene.input(), "not finite");
  scene = flatScene({8, 6});
  scene.camera.near_m = 0.0;
  expectRefused(scene.input(), "near_m");
  scene = flatScene({8, 6});
  scene.camera.size = {0, 6};
  expectRefused(scene.input(), "0x6");
}

TEST(OracleInput, ParametersOutsideTheirRangeAreRefusedByName) {
  const AnalyticScene scene = flatScene({8, 6});
  const auto refused = [&](auto TraceParameters::*member, auto value, const std::string& name) {
    TraceParameters parameters;
    parameters.*member = value;
    expectRefused(scene.input(parameters), name);
  };
  refused(&TraceParameters::lookup_budget, -1, "lookup_budget");
  refused(&TraceParameters::thickness_m, -0.5, "thickness_m");
  refused(&TraceParameters::thickness_m, std::nan(""), "thickness_m");
  refused(&TraceParameters::thickness_rel, kInfinity, "thickness_rel");
  refused(&TraceParameters::max_distance_m, 0.0, "max_distance_m");
  refused(&TraceParameters::origin_bias, -0.1, "origin_bias");
}

}  // namespace ssrkit::testing
