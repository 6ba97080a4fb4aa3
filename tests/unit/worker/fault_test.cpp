#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>

#include "../temporary_folder.h"
#include "fake_worker.h"

namespace ssrkit {

namespace {

class Fault : public ::testing::Test {
 protected:
  ~Fault() override { ::unsetenv("SSRKIT_FAULT"); }
  static void set(const char* fault) { ::setenv("SSRKIT_FAULT", fault, 1); }
};

TEST_F(Fault, ACrashStrikesTheNamedJobOnTheNamedDeviceAndNoOther) {
  set("crash:fake alive: read the");
  Worker worker = fakeWorker();
  EXPECT_TRUE(std::holds_alternative<JobResult>(worker.run(fakeJob("sample"), kAmple)));
  const JobOutcome outcome = worker.run(fakeJob("alive"), kAmple);
  ASSERT_TRUE(std::holds_alternative<WorkerDeath>(outcome));
  EXPECT_EQ(std::get<WorkerDeath>(outcome).signal, SIGSEGV);
  EXPECT_EQ(std::get<WorkerDeath>(outcome).last_progress, "read the scene");
  EXPECT_TRUE(std::holds_alternative<JobResult>(worker.run(fakeJob("sample"), kAmple)));
}

TEST_F(Fault, AHangRunsIntoTheWallLimitAndASpinIntoTheCpuLimit) {
  for (const char* const fault : {"hang:read the scene", "spin:read the scene"}) {
    set(fault);
    Worker worker = fakeWorker();
    const JobOutcome outcome =
        worker.run(fakeJob("alive"), {std::chrono::milliseconds(200), std::chrono::seconds(9)});
    ASSERT_TRUE(std::holds_alternative<WorkerDeath>(outcome)) << fault;
    EXPECT_EQ(std::get<WorkerDeath>(outcome).kind, WorkerDeath::Kind::kTimeout);
  }
  Worker worker = fakeWorker();
  const JobOutcome outcome =
      worker.run(fakeJob("alive"), {std::chrono::milliseconds(60000), std::chrono::seconds(1)});
  ASSERT_TRUE(std::holds_alternative<WorkerDeath>(outcome));
  EXPECT_EQ(std::get<WorkerDeath>(outcome).signal, SIGXCPU);
}

TEST_F(Fault, AFaultThatComesAfterSomethingWaitsForItInTheSameWorker) {
  set("crash:fake alive: read the;after=fake sample:");
  Worker worker = fakeWorker();
  EXPECT_TRUE(std::holds_alternative<JobResult>(worker.run(fakeJob("alive"), kAmple)));
  EXPECT_TRUE(std::holds_alternative<JobResult>(worker.run(fakeJob("sample"), kAmple)));
  EXPECT_TRUE(std::holds_alternative<WorkerDeath>(worker.run(fakeJob("alive"), kAmple)));
  EXPECT_TRUE(std::holds_alternative<JobResult>(worker.run(fakeJob("alive"), kAmple))) << "a new worker";
}

TEST_F(Fault, AFaultThatComesOnceLeavesItsFileAndLetsTheNextBe) {
  const test::TemporaryFolder folder;
  const std::string file = (folder / "struck").string();
  set(("crash:fake alive: read the;once=" + file).c_str());
  Worker worker = fakeWorker();
  EXPECT_TRUE(std::holds_alternative<WorkerDeath>(worker.run(fakeJob("alive"), kAmple)));
  EXPECT_TRUE(std::filesystem::exists(file));
  EXPECT_TRUE(std::holds_alternative<JobResult>(worker.run(fakeJob("alive"), kAmple)));
}

TEST_F(Fault, AWrongAnswerMovesEveryHitByOneTexel) {
  const auto recordOf = [](const JobOutcome& outcome) {
    return std::get<JobResult>(outcome).traces.at(0).record.rays;
  };
  const auto right = recordOf(fakeWorker().run(fakeJob("sample"), kAmple));
  set("wrong:fake sample: answer");
  const auto wrong = recordOf(fakeWorker().run(fakeJob("sample"), kAmple));
  ASSERT_EQ(right.size(), wrong.size());
  std::size_t hits = 0;
  for (std::size_t i = 0; i < right.size(); ++i) {
    const bool is_hit = right[i].ray_class == RayClass::kHit;
    EXPECT_EQ(right[i].texel_x + (is_hit ? 1 : 0), wrong[i].texel_x);
    hits += is_hit ? 1 : 0;
  }
  EXPECT_GT(hits, 0U);
}

TEST_F(Fault, AFaultOfAnUnknownKindIsAnErrorAndNotAnOmission) {
  for (const char* const fault : {"explode:now", "crash", "", "crash:a;before=b"}) {
    set(fault);
    const Expected<DeviceInfo> info = fakeWorker().info();
    ASSERT_FALSE(info) << fault;
    EXPECT_EQ(info.error().attempted, "read SSRKIT_FAULT");
  }
}

}  // namespace

}  // namespace ssrkit
