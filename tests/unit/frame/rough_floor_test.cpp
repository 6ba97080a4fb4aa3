#include "rough_floor_test.h"

#include <algorithm>

#include "../kit_shaders.h"
#include "frame/gbuffer_source.h"
#include "frame/stages.h"
#include "frame/trace_pass.h"
#include "rough_floor.h"

namespace ssrkit {

void RoughFloorTest::SetUp() {
  PassTest::SetUp();
  settings_.shader_root = kitShaders();
  programs_.emplace(*device_, target_);
  images_.emplace(*device_, kFloorSize);
  giveFloor(floorGbuffer([](int) { return kFloorRoughness; }));
  setCameraUniforms(values_, floorCamera());
  setTraceUniforms(values_, withStageDefaults({}, **findStage("walk"), kFloorSize));
  values_.set("up_view", glm::dvec3(0, 1, 0));
  values_.set("sky_horizon", kFloorHorizon);
  values_.set("sky_zenith", kFloorZenith);
}

void RoughFloorTest::giveFloor(const std::map<std::string, Image>& gbuffer) {
  ASSERT_TRUE(uploadGbuffer(*device_, gbuffer, floorCamera(), *images_).has_value());
  ASSERT_TRUE(uploadImage(*device_, **images_->get("lit"), gbuffer.at("lit"), {0, 0, 0, 1}).has_value());
}

void RoughFloorTest::replace(const std::string& pass, const std::string& shader) {
  const std::filesystem::path file(shader);
  settings_.replacements.clear();
  if (file.is_absolute()) {
    settings_.replacements[pass] = file;
  }
}

void RoughFloorTest::drawAll(const std::vector<FramePass>& passes) {
  const auto prepared = preparePasses(*programs_, settings_, passes, [](const std::string&) {});
  ASSERT_TRUE(prepared.has_value()) << sentence(prepared.error());
  for (const PreparedPass& pass : *prepared) {
    const auto time = drawPass(*device_, pass, *images_, values_);
    ASSERT_TRUE(time.has_value()) << sentence(time.error());
  }
}

std::map<int, Image> RoughFloorTest::means(const std::string& technique, int sample_count,
                                           const std::vector<int>& counts) {
  const auto row = findTechnique(technique);
  EXPECT_TRUE(row.has_value());
  std::vector<FramePass> each = (*row)->before_trace;
  std::ranges::copy(tracePasses("trace_walk.frag", **row), std::back_inserter(each));
  each.insert(each.end(), (*row)->after_sample.begin(), (*row)->after_sample.end());
  std::map<int, Image> at;
  for (int sample = 0; sample < sample_count; ++sample) {
    values_.set("sample_index", sample);
    values_.set("sample_count", sample_count);
    values_.set("frame_index", 0);
    drawAll(each);
    if (std::ranges::find(counts, sample + 1) != counts.end()) {
      values_.set("sample_count", sample + 1);
      drawAll({(*row)->after_trace.front()});
      at[sample + 1] = read("reflection");
    }
  }
  return at;
}

Image RoughFloorTest::read(const std::string& image) {
  const auto texels = readImage(*device_, *images_->find(image), {"R", "G", "B", "A"});
  EXPECT_TRUE(texels.has_value());
  return *texels;
}

}  // namespace ssrkit
