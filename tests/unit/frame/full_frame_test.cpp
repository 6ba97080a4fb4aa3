// Every technique over a frame whose lit image holds the environment's reflection already.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>

#include "../kit_shaders.h"
#include "base/atomic_file.h"
#include "frame/frames.h"
#include "frame/run_job.h"
#include "frame/technique_in_frame.h"
#include "pass_test.h"
#include "rough_floor.h"

namespace ssrkit {
namespace {

constexpr float kOneRadiance = 0.5F;

// Of perfect metal, three strips of roughness; everything, the environment too, has one radiance, and all of
// the floor's is the environment's that it reflects.
Job furnace() {
  Job job;
  job.id = "furnace";
  job.size = kFloorSize;
  job.frame = "full";
  job.shader_root = kitShaders();
  job.environment = EnvironmentChoice{.file = {}, .constant = glm::vec3(kOneRadiance)};
  job.gbuffer_camera = floorCamera();
  job.gbuffer = floorGbuffer([](int x) { return x < 20 ? 0.0 : x < 40 ? 0.3125 : 0.75; });
  std::ranges::fill(job.gbuffer.at("lit").data, kOneRadiance);
  Image base = job.gbuffer.at("lit");
  for (std::size_t i = 0; i < base.data.size(); ++i) {
    const bool is_floor = i >= std::size_t{3} * kFloorSize.width * kFirstFloorRow;
    base.data[i] = is_floor ? 0.0F : kOneRadiance;
  }
  job.gbuffer["lit_base"] = std::move(base);
  return job;
}

// They add to the lit image as published; docs/techniques.md has the gain of each.
bool addsByDesign(const Technique& technique) {
  return technique.name == "additive" || technique.name == "metallic";
}

// An entry file, to be removed, that gives every texel one value.
std::filesystem::path paintOf(const std::string& type, const std::string& value) {
  std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("ssrkit-paint-" + std::to_string(getpid()) + ".frag");
  const auto written = writeFileAtomically(file, fmt::format("#version 450\n"
                                                             "layout(location = 0) out {} painted;\n"
                                                             "void main() {{ painted = {}; }}\n",
                                                             type, value));
  EXPECT_TRUE(written.has_value());
  return file;
}

class FullFrameTest : public PassTest {
 protected:
  JobResult run(const Job& job) {
    auto result = JobRunner(*device_, target_).run(job, [](const std::string&) {});
    EXPECT_TRUE(result.has_value()) << sentence(result.error());
    return result ? *std::move(result) : JobResult{};
  }

  // "" when the technique shows nothing but the furnace, to within a half's rounding, twice.
  std::string keepsTheFurnace(const Technique& technique, Job job) {
    job.sequence.frame_count = technique.frame_count;
    job.traces = {{.stage = "hiz", .parameters = {}, .technique = technique.name}};
    const JobResult result = run(job);
    const std::string wrong = followsFormula(
        result.traces.at(0).images.at("composite"), [](int, int) { return kOneRadiance; },
        1e-3 * kOneRadiance);
    return wrong.empty() ? "" : fmt::format("{}: {}", technique.name, wrong);
  }
};

TEST_P(FullFrameTest, EveryTechniqueThatReplacesOrBlendsKeepsAFurnace) {
  const auto check = [&](const std::string& composite) -> std::string {
    Job job = furnace();
    if (std::filesystem::path(composite).is_absolute()) {
      job.replacements = {{.pass = "composite_replace", .file = composite}};
      job.may_replace_nothing = true;  // some techniques have a pass of their own for it
    }
    for (const Technique& technique : techniques()) {
      const bool is_drawn = technique.frame.empty() || technique.frame == "full";
      const std::string wrong =
          is_drawn && !addsByDesign(technique) ? keepsTheFurnace(technique, job) : std::string();
      if (!wrong.empty()) {
        return wrong;
      }
    }
    return "";
  };
  holdsAndKills(check, "composite_replace.frag", {"composite_over_lit"});
}

// The same check sees those that do not.
TEST_P(FullFrameTest, WhatAddsByDesignDoesNot) {
  for (const Technique& technique : techniques()) {
    if (addsByDesign(technique)) {
      EXPECT_NE(keepsTheFurnace(technique, furnace()), "") << technique.name;
    }
  }
}

// What found nothing shows the lit image itself, and every ray's verdict is the same as in the basic frame.
TEST_P(FullFrameTest, AMissLeavesTheLitImageAsItIs) {
  Job job = furnace();
  for (const char* technique : {"mirror", "confidence", "history", "temporal", "normals_octahedral"}) {
    job.traces.push_back({.stage = "hiz", .parameters = {}, .technique = technique});
  }
  const JobResult result = run(job);
  const Image& lit = result.images.at("lit");
  for (const TraceResult& trace : result.traces) {
    int missed = 0;
    for (int y = 0; y < kFloorSize.height; ++y) {
      for (int x = 0; x < kFloorSize.width; ++x) {
        const bool is_hit = trace.record.at(x, y).ray_class == RayClass::kHit;
        missed += is_hit ? 0 : 1;
        ASSERT_TRUE(is_hit || trace.images.at("composite").at(x, y) == lit.at(x, y)) << trace.technique;
      }
    }
    EXPECT_GT(missed, 100) << trace.technique;
  }
}

// Passes that paint all that they are drawn to, over a scene: its surfaces, and the clear where there are
// none.
TEST_P(FullFrameTest, DrawsShadowAndObscuranceWhereSurfacesAreAndNowhereElse) {
  const std::filesystem::path paint = paintOf("float", "2.0");
  Job job;
  job.id = "curved";
  job.scene_file = std::filesystem::path(SSRKIT_SOURCE_DIR) / "scenes/curved/curved.gltf";
  job.size = {97, 53};
  job.frame = "full";
  job.shader_root = kitShaders();
  job.replacements = {{.pass = "shadow", .file = paint}, {.pass = "ao_blur_down", .file = paint}};
  const JobResult result = run(job);
  std::filesystem::remove(paint);
  const Image& dist_view = result.images.at("dist_view");
  const auto painted = [&](int x, int y) { return std::isinf(dist_view.at(x, y)) ? 1.0 : 2.0; };
  EXPECT_EQ(followsFormula(result.images.at("shadow"), painted, 0.0), "");
  EXPECT_EQ(followsFormula(result.images.at("ao"), painted, 0.0), "");
}

// A last pass that paints all that it is drawn to: nothing but the floor, which two passes before it covered
// too.
TEST_P(FullFrameTest, DrawsWhatFollowsTheTraceWhereRaysStartAndNowhereElse) {
  const std::filesystem::path paint = paintOf("vec4", "vec4(2.0)");
  Job job = furnace();
  job.traces = {{.stage = "hiz", .parameters = {}, .technique = "replace"}};
  job.replacements = {{.pass = "resolve", .file = paint}, {.pass = "composite_replace", .file = paint}};
  const JobResult result = run(job);
  std::filesystem::remove(paint);
  const std::map<std::string, Image>& images = result.traces.at(0).images;
  const auto is_floor = [](int y) { return y >= kFirstFloorRow; };
  EXPECT_EQ(followsFormula(
                images.at("reflection"), [&](int, int y) { return is_floor(y) ? 2.0 : 0.0; }, 0.0),
            "");
  EXPECT_EQ(
      followsFormula(
          images.at("composite"), [&](int, int y) { return is_floor(y) ? 2.0 : double{kOneRadiance}; }, 0.0),
      "");
}

TEST_P(FullFrameTest, NamesTheRowThatIsMadeForIt) {
  const auto full = findFrameKind("full");
  ASSERT_TRUE(full.has_value());
  std::set<std::string> refused;
  for (const Technique& technique : techniques()) {
    if (const auto drawn = inFrame(technique, **full); !drawn) {
      refused.insert(technique.name);
      EXPECT_NE(sentence(drawn.error()).find("it needs the frame 'basic'"), std::string::npos);
    }
  }
  EXPECT_EQ(refused, (std::set<std::string>{"ggx_1", "ggx_4", "ggx_16", "ggx_16_white", "ggx_128",
                                            "stochastic", "ggx_temporal"}));
  EXPECT_NE(
      sentence(inFrame(**findTechnique("ggx_16"), **full).error()).find("'replace_ggx_16' does the same"),
      std::string::npos);
  Job job = furnace();
  job.traces = {{.stage = "hiz", .parameters = {}, .technique = "stochastic"}};
  const auto result = JobRunner(*device_, target_).run(job, [](const std::string&) {});
  ASSERT_FALSE(result.has_value());
  EXPECT_NE(sentence(result.error()).find("'replace_stochastic' does the same there"), std::string::npos)
      << sentence(result.error());
}

INSTANTIATE_TEST_SUITE_P(Each, FullFrameTest, testing::Values("gl-osmesa", "vk-lavapipe"), deviceTestName);

}  // namespace
}  // namespace ssrkit
