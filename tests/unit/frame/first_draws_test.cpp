// A driver compiles before a pass's first draw, and says so; nothing is drawn by it.
#include "frame/first_draws.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "frame/run_job.h"
#include "frame_device.h"
#include "made_gbuffers.h"

namespace ssrkit {
namespace {

using Log = std::vector<std::string>;

// Writes down what is drawn, and leaves out draws that are to draw nothing where it is told to.
class Watches final : public ForwardingDevice {
 public:
  Watches(Device& device, Log& log, bool skips_nothings)
      : ForwardingDevice(device), log_(log), skips_nothings_(skips_nothings) {}
  [[nodiscard]] Expected<PassTime> draw(const PassDesc& pass) override {
    const bool is_nothing = pass.scissor && pass.scissor->width == 0 && pass.scissor->height == 0;
    log_.push_back((is_nothing ? "nothing of " : "all of ") + pass.name);
    return is_nothing && skips_nothings_ ? Expected<PassTime>(PassTime{}) : behind().draw(pass);
  }

 private:
  Log& log_;
  bool skips_nothings_;
};

class FirstDrawsTest : public FrameDeviceTest {
 protected:
  Expected<JobResult> run(Log& log, bool skips_nothings) {
    Watches watches(*device_, log, skips_nothings);
    Job job = randomBlocks({33, 17});
    job.traces = {{.stage = "walk"}, {.stage = "hiz"}};
    job.timing.rounds = 2;
    return JobRunner(watches, target_).run(job, [&log](const std::string& text) { log.push_back(text); });
  }
};

TEST_P(FirstDrawsTest, EachProgramIsBuiltOnceBeforeItIsDrawn) {
  Log log;
  const auto result = run(log, false);
  ASSERT_TRUE(result.has_value()) << sentence(result.error());
  const Log in_order = {"build trace_walk", "nothing of trace_walk", "draw trace_walk", "all of trace_walk"};
  EXPECT_NE(std::search(log.begin(), log.end(), in_order.begin(), in_order.end()), log.end());
  EXPECT_EQ(std::ranges::count(log, "nothing of trace_walk"), 1);
  EXPECT_EQ(std::ranges::count(log, "all of trace_walk"), 3) << "the first time and two rounds";
}

TEST_P(FirstDrawsTest, WhatIsBuiltDrawsNothing) {
  Log log;
  const auto with = run(log, false);
  const auto without = run(log, true);
  ASSERT_TRUE(with && without);
  for (std::size_t trace = 0; trace < 2; ++trace) {
    const RayRecord& record = with->traces[trace].record;
    ASSERT_EQ(record.rays.size(), without->traces[trace].record.rays.size());
    for (std::size_t i = 0; i < record.rays.size(); ++i) {
      const RayHit& ray = without->traces[trace].record.rays[i];
      EXPECT_EQ(record.rays[i].ray_class, ray.ray_class);
      EXPECT_EQ(record.rays[i].t_m, ray.t_m);
      EXPECT_EQ(record.rays[i].steps, ray.steps);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Devices, FirstDrawsTest, testing::Values("gl-osmesa", "vk-lavapipe"),
                         deviceTestName);

}  // namespace
}  // namespace ssrkit
