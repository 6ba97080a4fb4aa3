// A driver compiles a shader once, however often it is drawn with. Lavapipe makes a constant of a uniform
// that a branch or a loop's end hangs on alone, and with it a new shader at every draw, whose code it keeps.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <optional>
#include <string>

#include "../kit_shaders.h"
#include "frame/run_job.h"
#include "frame/stages.h"
#include "frame/techniques.h"
#include "frame_device.h"

namespace ssrkit {
namespace {

// Stretches of this process's memory that hold code of no file: one for each shader that the driver has
// compiled.
int compiledShaders() {
  std::ifstream maps("/proc/self/maps");
  int count = 0;
  for (std::string line; std::getline(maps, line);) {
    const bool is_code = line.find(" r-xp ") != std::string::npos;
    count += is_code && line.find('/') == std::string::npos && line.find('[') == std::string::npos ? 1 : 0;
  }
  return count;
}

Job glossJob(const TraceRequest& trace, const Technique& technique) {
  Job job;
  job.id = fmt::format("{} of {}", technique.name, trace.stage);
  job.scene_file = SSRKIT_SOURCE_DIR "/scenes/gloss/gloss.gltf";
  job.size = {48, 27};
  job.frame = technique.frame.empty() ? "basic" : technique.frame;
  job.sequence.frame_count = technique.frame_count;
  job.traces = {trace};
  job.shader_root = kitShaders();
  return job;
}

class KeptCodeTest : public FrameDeviceTest {
 protected:
  void SetUp() override {
    FrameDeviceTest::SetUp();
    ASSERT_NE(device_, nullptr);
    runner_.emplace(*device_, target_);
  }
  void TearDown() override {
    runner_.reset();
    FrameDeviceTest::TearDown();
  }

  // How many shaders were compiled by drawing the job again, when it was drawn twice.
  int compiledAgain(const Job& job) {
    const auto draw = [&] {
      const auto result = runner_->run(job, [](const std::string&) {});
      EXPECT_TRUE(result.has_value()) << sentence(result.error());
    };
    draw();
    draw();
    const int before = compiledShaders();
    EXPECT_GT(before, 0) << "this driver's code is not found";
    draw();
    return compiledShaders() - before;
  }

  std::optional<JobRunner> runner_;
};

TEST_P(KeptCodeTest, NoTechniqueIsCompiledAtEachDraw) {
  for (const Technique& technique : techniques()) {
    const TraceRequest trace{.stage = "hiz", .parameters = {}, .technique = technique.name};
    EXPECT_LE(compiledAgain(glossJob(trace, technique)), 0) << technique.name;
  }
}

TEST_P(KeptCodeTest, NoStageIsCompiledAtEachDraw) {
  const auto mirror = findTechnique("mirror");
  ASSERT_TRUE(mirror.has_value());
  for (const Stage& stage : stages()) {
    for (const TracerForm form : {TracerForm::kTextbook, TracerForm::kTuned}) {
      TraceRequest trace{.stage = stage.name, .parameters = {}, .technique = "mirror"};
      trace.parameters.form = form;
      EXPECT_LE(compiledAgain(glossJob(trace, **mirror)), 0) << stage.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Each, KeptCodeTest, testing::Values("vk-lavapipe"), deviceTestName);

}  // namespace
}  // namespace ssrkit
