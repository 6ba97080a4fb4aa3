#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>

#include "fake_worker.h"

namespace ssrkit {

namespace {

const JobLimits kAmple{std::chrono::milliseconds(60000), std::chrono::seconds(60)};

class Fault : public testing::Test {
 protected:
  ~Fault() override { ::unsetenv("SSRKIT_FAULT"); }
  static void set(const char* fault) { ::setenv("SSRKIT_FAULT", fault, 1); }
};

}  // namespace

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

TEST_F(Fault, AFaultOfAnUnknownKindIsAnErrorAndNotAnOmission) {
  for (const char* const fault : {"explode:now", "crash", ""}) {
    set(fault);
    const Expected<DeviceInfo> info = fakeWorker().info();
    ASSERT_FALSE(info) << fault;
    EXPECT_EQ(info.error().attempted, "read SSRKIT_FAULT");
  }
}

}  // namespace ssrkit
