#include "frame/stages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace ssrkit {
namespace {

TEST(Stages, HaveTheirShaders) {
  for (const Stage& stage : stages()) {
    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(SSRKIT_SOURCE_DIR) / "shaders" / stage.shader));
    EXPECT_TRUE(
        std::filesystem::exists(std::filesystem::path(SSRKIT_SOURCE_DIR) / "shaders" / stage.tuned_shader));
  }
}

TEST(Stages, AreFoundByNameAndMisspellingsGetASuggestion) {
  EXPECT_EQ((*findStage("hiz"))->name, "hiz");
  const auto misspelt = findStage("hzi");
  ASSERT_FALSE(misspelt.has_value());
  EXPECT_EQ(sentence(misspelt.error()),
            "could not find the stage 'hzi': there is no such stage; did you mean 'hiz'?");
}

TEST(StagePresets, AreParametersInRange) {
  for (const Stage& stage : stages()) {
    for (const auto& [name, value] : stage.preset) {
      TraceParameters parameters;
      const auto set = setParameter(parameters, name, value, stage.name);
      EXPECT_TRUE(set.has_value()) << sentence(set.error());
    }
  }
}

TEST(StagePresets, StandOverTheScenesValuesAndUnderWhatWasChosen) {
  const Stage& dda_8_4 = **findStage("dda_8_4");
  const TraceParameters scene{.thickness_m = 0.3, .bisection_count = 7, .stride_px = 2};
  const TraceParameters asked = askedParameters(scene, dda_8_4, {});
  EXPECT_EQ(asked.thickness_m, 0.3);
  EXPECT_EQ(asked.bisection_count, 4);
  EXPECT_EQ(asked.stride_px, 8);
  const TraceParameters chosen =
      askedParameters(scene, dda_8_4, {{"stride_px", "16"}, {"thickness_m", "inf"}});
  EXPECT_EQ(chosen.stride_px, 16);
  EXPECT_TRUE(std::isinf(chosen.thickness_m));
  EXPECT_EQ(chosen.bisection_count, 4);
}

TEST(FirstStepShare, MakesTheGrowingStepsAsLongAsTheRay) {
  for (const double growth : {1.0, 1.001, 1.05, 2.0}) {
    double step = firstStepShare(growth, 24);
    double sum = 0.0;
    for (int i = 0; i < 24; ++i) {
      sum += step;
      step *= growth;
    }
    EXPECT_NEAR(sum, 1.0, 1e-9) << growth;
  }
  EXPECT_GT(firstStepShare(4.0, 16384), 0.0);
}

TEST(StageDefaults, FillOnlyWhatWasLeftOpen) {
  const Stage& naive = **findStage("naive");
  EXPECT_EQ(withStageDefaults({}, naive, {640, 360}).step_count, naive.default_step_count);
  EXPECT_EQ(withStageDefaults({.step_count = 7}, naive, {640, 360}).step_count, 7);
  EXPECT_EQ(withStageDefaults({.bisection_count = 0}, **findStage("refined"), {640, 360}).bisection_count, 0);
}

TEST(StageDefaults, ClimbNoHigherThanOneCellForTheWholeImage) {
  const Stage& hiz = **findStage("hiz");
  EXPECT_EQ(withStageDefaults({}, hiz, {1, 1}).max_mip, 0);
  EXPECT_EQ(withStageDefaults({}, hiz, {2, 1}).max_mip, 1);
  EXPECT_EQ(withStageDefaults({}, hiz, {3, 3}).max_mip, 2);
  EXPECT_EQ(withStageDefaults({}, hiz, {16, 5}).max_mip, 4);
  EXPECT_EQ(withStageDefaults({.max_mip = 2}, hiz, {640, 360}).max_mip, 2);
  EXPECT_EQ(withStageDefaults({}, hiz, {16384, 16}).max_mip, hiz.default_max_mip);
}

}  // namespace
}  // namespace ssrkit
