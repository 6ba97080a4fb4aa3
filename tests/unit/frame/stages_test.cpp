#include "frame/stages.h"

#include <gtest/gtest.h>

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
