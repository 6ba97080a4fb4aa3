// Whole jobs on each device over G-buffers made by formula.
#include "frame/run_job.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <string>

#include "../kit_shaders.h"
#include "base/atomic_file.h"
#include "frame/frames.h"
#include "frame/techniques.h"
#include "frame_device.h"
#include "hit_bits.h"

namespace ssrkit {
namespace {

// M1 at 256 x 256 by its formulas: mirror floor one metre below, wall eight metres ahead, f = 2.
Job m1ByFormula() {
  const Size size{256, 256};
  Job job;
  job.id = "m1 by formula";
  job.size = size;
  job.shader_root = kitShaders();
  job.gbuffer_camera = Camera{.size = size,
                              .clip_from_view = perspective(2.0 * std::atan(0.5), 1.0, 0.1, 100.0),
                              .view_from_world = glm::dmat4(1.0),
                              .near_m = 0.1,
                              .far_m = 100.0};
  Image dist_view(size, {"Z"});
  Image normal_view(size, {"R", "G", "B"});
  Image material(size, {"R", "G", "B"});
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const double ndc_y = 1.0 - (y + 0.5) / 128.0;
      const bool is_floor = y >= 160;
      dist_view.at(x, y) = static_cast<float>(is_floor ? 2.0 / -ndc_y : 8.0);
      normal_view.at(x, y, is_floor ? 1 : 2) = 1.0F;
      material.at(x, y, 2) = is_floor ? 1.0F : 0.0F;
    }
  }
  job.gbuffer = {{"dist_view", dist_view}, {"normal_view", normal_view}, {"material", material}};
  return job;
}

Expected<JobResult> runJob(Device& device, ShaderTarget target, const Job& job) {
  return JobRunner(device, target).run(job, [](const std::string&) {});
}

std::filesystem::path minePath() {
  return std::filesystem::temp_directory_path() / ("ssrkit-mine-" + std::to_string(getpid()) + ".frag");
}

class RunJobTest : public FrameDeviceTest {
 protected:
  // The sentence that a job with this fragment shader in the place of trace_walk ends with.
  [[nodiscard]] std::string refusalOf(const std::string& glsl) {
    const std::filesystem::path file = minePath();
    EXPECT_TRUE(writeFileAtomically(file, glsl).has_value());
    Job job = m1ByFormula();
    job.traces = {{.stage = "walk"}};
    job.replacements = {{.pass = "walk", .file = file}};
    const auto result = runJob(*device_, target_, job);
    std::filesystem::remove(file);
    return result ? "" : sentence(result.error());
  }
};

TEST_P(RunJobTest, EveryMirrorTexelOfM1HitsRow319MinusItsOwn) {
  Job job = m1ByFormula();
  job.traces = {{.stage = "walk"},
                {.stage = "hiz"},
                {.stage = "dda"},
                {.stage = "hiz", .parameters = {.form = TracerForm::kTextbook}}};
  const auto result = runJob(*device_, target_, job);
  ASSERT_TRUE(result.has_value()) << sentence(result.error());
  for (const TraceResult& trace : result->traces) {
    for (int y = 0; y < 256; ++y) {
      for (int x = 0; x < 256; ++x) {
        const RayHit& ray = trace.record.at(x, y);
        ASSERT_EQ(ray.ray_class, y >= 160 ? RayClass::kHit : RayClass::kMasked)
            << trace.stage << " " << x << " " << y;
        ASSERT_EQ(ray.texel_x, y >= 160 ? x : -1) << trace.stage << " " << x << " " << y;
        ASSERT_EQ(ray.texel_y, y >= 160 ? 319 - y : -1) << trace.stage << " " << x << " " << y;
        if (trace.stage == "walk") {
          ASSERT_EQ(ray.lookups, y >= 160 ? static_cast<std::uint32_t>(2 * y - 319) : 0U);
        }
      }
    }
  }
}

TEST_P(RunJobTest, TheTunedFormGivesTheTextbooksBitsOverRandomDepths) {
  Job job = m1ByFormula();
  std::mt19937 random(11);
  std::uniform_real_distribution<float> metres(1.0F, 12.0F);
  for (float& dist : job.gbuffer.at("dist_view").data) {
    dist = metres(random);
  }
  for (float& value : job.gbuffer.at("material").data) {
    value = 1.0F;
  }
  for (const double thickness_m : {0.05, 0.5, 1e9}) {
    job.traces.push_back(
        {.stage = "hiz", .parameters = {.thickness_m = thickness_m, .form = TracerForm::kTextbook}});
    job.traces.push_back({.stage = "hiz", .parameters = {.thickness_m = thickness_m}});
  }
  const auto result = runJob(*device_, target_, job);
  ASSERT_TRUE(result.has_value()) << sentence(result.error());
  for (std::size_t i = 0; i < result->traces.size(); i += 2) {
    for (std::size_t ray = 0; ray < result->traces[i].record.rays.size(); ++ray) {
      const RayHit& textbook = result->traces[i].record.rays[ray];
      const RayHit& tuned = result->traces[i + 1].record.rays[ray];
      ASSERT_EQ(textbook.ray_class, tuned.ray_class) << ray;
      ASSERT_EQ(textbook.texel_x, tuned.texel_x) << ray;
      ASSERT_EQ(textbook.texel_y, tuned.texel_y) << ray;
      ASSERT_EQ(pointBits(textbook), pointBits(tuned)) << ray;
    }
  }
}

TEST_P(RunJobTest, TimesInterleavedRoundsAfterAColdOne) {
  Job job = m1ByFormula();
  job.traces = {{.stage = "walk", .technique = ""}, {.stage = "hiz", .technique = ""}};
  job.timing.rounds = 3;
  const auto result = runJob(*device_, target_, job);
  ASSERT_TRUE(result.has_value()) << sentence(result.error());
  ASSERT_EQ(result->traces[1].passes.size(), 2U);
  EXPECT_EQ(result->traces[1].passes[0].pass, "pyramid");
  EXPECT_EQ(result->traces[1].passes[1].pass, "trace");
  for (const TraceResult& trace : result->traces) {
    EXPECT_EQ(trace.passes.back().steady.size(), 3U);
    EXPECT_GT(trace.passes.back().steady[0].cpu_ns, 0);
  }
}

TEST_P(RunJobTest, EveryTechniqueMakesAFinitePictureOfM1) {
  for (const Technique& technique : techniques()) {
    Job job = m1ByFormula();
    job.frame = technique.frame.empty() ? "basic" : technique.frame;
    job.traces = {{.stage = "hiz", .technique = technique.name}};
    const auto result = runJob(*device_, target_, job);
    ASSERT_TRUE(result.has_value()) << technique.name << ": " << sentence(result.error());
    for (const std::string& name : technique.read_back) {
      const Image& image = result->traces.front().images.at(name);
      EXPECT_TRUE(std::ranges::all_of(image.data, [](float value) { return std::isfinite(value); }))
          << technique.name << " " << name;
    }
    const Image& composite = result->traces.front().images.at("composite");
    EXPECT_EQ(composite.size, job.size) << technique.name;
    EXPECT_TRUE(std::ranges::any_of(composite.data, [](float value) { return value > 0.0F; }))
        << technique.name;
  }
}

TEST_P(RunJobTest, EveryFrameMakesTheTechniqueItIsShownWith) {
  for (const FrameKind& kind : frameKinds()) {
    Job job = m1ByFormula();
    job.frame = kind.name;
    job.traces = {{.stage = "hiz", .technique = kind.technique}};
    const auto result = runJob(*device_, target_, job);
    ASSERT_TRUE(result.has_value()) << kind.name << ": " << sentence(result.error());
    EXPECT_TRUE(result->images.contains("lit")) << kind.name;
    ASSERT_EQ(result->frame_passes.size(), kind.passes.size()) << kind.name;
  }
}

TEST_P(RunJobTest, NeedsBothLitImagesOrNeitherWhereOneHasNoSpecular) {
  Job job = m1ByFormula();
  job.frame = "full";
  job.traces = {{.stage = "walk", .technique = "replace"}};
  job.gbuffer["lit"] = Image(job.size, {"R", "G", "B"});
  const auto alone = runJob(*device_, target_, job);
  ASSERT_FALSE(alone.has_value());
  EXPECT_NE(sentence(alone.error()).find("it has 'lit' alone; the frame 'full' needs both"),
            std::string::npos)
      << sentence(alone.error());
  job.gbuffer["lit_base"] = job.gbuffer["lit"];
  const auto both = runJob(*device_, target_, job);
  ASSERT_TRUE(both.has_value()) << sentence(both.error());
  EXPECT_EQ(std::ranges::find(both->frame_passes, "light_ggx", &PassReport::pass), both->frame_passes.end());
}

TEST_P(RunJobTest, NamesTheTechniqueThatDoesNotExist) {
  Job job = m1ByFormula();
  job.traces = {{.stage = "walk", .technique = "mirorr"}};
  const auto result = runJob(*device_, target_, job);
  ASSERT_FALSE(result.has_value());
  EXPECT_NE(sentence(result.error()).find("did you mean 'mirror'?"), std::string::npos);
}

TEST_P(RunJobTest, NamesTheStageThatDoesNotExist) {
  Job job = m1ByFormula();
  job.traces = {{.stage = "walks"}};
  const auto result = runJob(*device_, target_, job);
  ASSERT_FALSE(result.has_value());
  EXPECT_NE(sentence(result.error()).find("did you mean 'walk'?"), std::string::npos);
}

TEST_P(RunJobTest, NamesThePassThatCannotBeReplaced) {
  Job job = m1ByFormula();
  job.traces = {{.stage = "walk"}};
  job.replacements = {{.pass = "trace_wlak", .file = "mine.frag"}};
  const auto result = runJob(*device_, target_, job);
  ASSERT_FALSE(result.has_value());
  EXPECT_NE(sentence(result.error()).find("did you mean 'trace_walk'?"), std::string::npos);
}

TEST_P(RunJobTest, RefusesAReplacementOfAPassThatItDoesNotDraw) {
  Job job = m1ByFormula();
  job.traces = {{.stage = "walk"}, {.stage = "dda"}};
  // The G-buffer was given, the frame is "basic", the technique "mirror", and neither tracer reads a pyramid.
  for (const char* pass : {"gbuffer", "shadow", "ao", "shadow_map", "accumulate", "composite_replace",
                           "pyramid_base", "pyramid_reduce", "hiz", "trace_hiz_tuned"}) {
    job.replacements = {{.pass = "dda", .file = kitShaders() / "trace_dda.frag"},
                        {.pass = pass, .file = "missing.frag"}};
    const auto result = runJob(*device_, target_, job);
    ASSERT_FALSE(result.has_value()) << pass;
    const std::string text = sentence(result.error());
    EXPECT_NE(text.find(fmt::format("replace the pass '{}': this run does not draw it", pass)),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("its passes are light, "), std::string::npos) << text;
    EXPECT_NE(text.find("trace_dda and trace_walk"), std::string::npos) << text;
  }
}

TEST_P(RunJobTest, TakesReplacementsOfWhatItDrawsAndLeavesOthersWhereToldTo) {
  Job job = m1ByFormula();
  job.traces = {{.stage = "hiz"}};
  for (const char* pass :
       {"light", "resolve", "composite", "pyramid_base", "pyramid_reduce", "without_ray"}) {
    job.replacements = {{.pass = pass, .file = kitShaders() / fmt::format("{}.frag", pass)}};
    const auto result = runJob(*device_, target_, job);
    EXPECT_TRUE(result.has_value()) << sentence(result.error());
  }
  job.replacements = {{.pass = "shadow", .file = "missing.frag"}};
  job.may_replace_nothing = true;
  const auto result = runJob(*device_, target_, job);
  ASSERT_TRUE(result.has_value()) << sentence(result.error());
  const std::set<std::string> drawn(result->drawn_passes.begin(), result->drawn_passes.end());
  EXPECT_TRUE(drawn.contains("light") && drawn.contains("pyramid_base") && !drawn.contains("shadow"));
}

// Not as a class that exists: no check would see it.
TEST_P(RunJobTest, KeepsAClassThatDoesNotExistAsTheShaderWroteIt) {
  const std::filesystem::path file = minePath();
  for (const auto& [written, kept] : {std::pair{"200", 200}, std::pair{"7", 7}, std::pair{"65535", 255}}) {
    ASSERT_TRUE(
        writeFileAtomically(
            file, fmt::format("#version 450\nlayout(location = 0) out ivec2 a;\n"
                              "layout(location = 1) out vec4 b;\nlayout(location = 2) out uvec4 c;\n"
                              "void main() {{ a = ivec2(-1); b = vec4(-1.0); c = uvec4({}u, 0, 0, 0); }}\n",
                              written))
            .has_value());
    Job job = m1ByFormula();
    job.traces = {{.stage = "walk", .parameters = {}, .technique = ""}};
    job.replacements = {{.pass = "walk", .file = file}};
    const auto result = runJob(*device_, target_, job);
    ASSERT_TRUE(result.has_value()) << sentence(result.error());
    const auto is_kept = [&](const RayHit& ray) { return static_cast<int>(ray.ray_class) == kept; };
    EXPECT_TRUE(std::ranges::any_of(result->traces[0].record.rays, is_kept)) << written;
  }
  std::filesystem::remove(file);
}

TEST_P(RunJobTest, RefusesAShaderWithTooFewOutputs) {
  EXPECT_NE(
      refusalOf(
          "#version 450\nlayout(location = 0) out ivec2 hit_texel;\nvoid main() { hit_texel = ivec2(0); }\n")
          .find("no output at location 1"),
      std::string::npos);
}

TEST_P(RunJobTest, RefusesASamplerThatNoImageIsCalled) {
  const std::string outputs =
      "layout(location = 0) out ivec2 a;\nlayout(location = 1) out vec4 b;\nlayout(location = 2) out uvec4 "
      "c;\n";
  const std::string text = refusalOf("#version 450\n" + outputs +
                                     "layout(binding = 1) uniform sampler2D depths;\nvoid main() {\n"
                                     "a = ivec2(0); b = texelFetch(depths, a, 0); c = uvec4(0);\n}\n");
  EXPECT_NE(text.find("no image is called 'depths'"), std::string::npos) << text;
}

TEST_P(RunJobTest, NamesTheAuthorsLineOfAShaderThatDoesNotCompile) {
  const std::string text = refusalOf("#version 450\n\nvoid main() {\n  int x = nothing;\n}\n");
  EXPECT_NE(text.find(".frag:4:"), std::string::npos) << text;
  EXPECT_NE(text.find("nothing"), std::string::npos) << text;
}

INSTANTIATE_TEST_SUITE_P(Each, RunJobTest, testing::Values("gl-osmesa", "vk-lavapipe"), deviceTestName);

}  // namespace
}  // namespace ssrkit
