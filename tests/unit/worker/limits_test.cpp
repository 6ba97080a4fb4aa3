// How long a worker may be at what.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <thread>

#include "fake_worker.h"
#include "worker/supervisor.h"

namespace ssrkit {

using std::chrono::milliseconds;
using std::chrono::seconds;

TEST(Limits, CompilingAndDrawingHaveLimitsOfTheirOwnAndADeathSaysWhich) {
  Worker worker = fakeWorker();
  ASSERT_TRUE(worker.info());
  const JobLimits short_compile{.wall = milliseconds(60000), .compile = milliseconds(300)};
  const JobLimits short_run{.wall = milliseconds(60000), .run = milliseconds(600)};
  const auto start = std::chrono::steady_clock::now();
  const WorkerDeath compiling = deathOf(worker.run(fakeJob("compile a.frag"), short_compile));
  EXPECT_EQ(compiling.kind, WorkerDeath::Kind::kTimeout);
  EXPECT_EQ(compiling.phase, JobPhase::kCompile);
  EXPECT_EQ(compiling.last_progress, "compile a.frag");
  const WorkerDeath drawing = deathOf(worker.run(fakeJob("draw trace"), short_run));
  EXPECT_EQ(drawing.phase, JobPhase::kRun);
  EXPECT_LT(std::chrono::steady_clock::now() - start, seconds(20));
  EXPECT_EQ(note(worker.run(fakeJob("many draws"), short_run)), "drawn") << "each draw has the limit anew";
  EXPECT_EQ(note(worker.run(fakeJob("alive"), kAmple)), "alive");
}

// As Ctrl-Z and `fg` do it. The worker, in a group of its own, goes on meanwhile: what it tells of its passes
// lies before the answer.
TEST(Limits, AnAnswerThatCameWhileTheSupervisorWasStoppedCounts) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  const pid_t supervisor = ::fork();
  if (supervisor == 0) {
    Worker worker = fakeWorker();
    const bool is_up = worker.info().has_value() && ::write(ends[1], "!", 1) == 1;
    const JobLimits limits{.wall = milliseconds(2000)};
    std::_Exit(is_up && note(worker.run(fakeJob("many draws"), limits)) == "drawn" ? 0 : 1);
  }
  ::close(ends[1]);
  char up = 0;
  ASSERT_EQ(::read(ends[0], &up, 1), 1);
  ::close(ends[0]);
  std::this_thread::sleep_for(milliseconds(100));
  ::kill(supervisor, SIGSTOP);
  std::this_thread::sleep_for(milliseconds(2500));
  ::kill(supervisor, SIGCONT);
  int status = 0;
  ASSERT_EQ(::waitpid(supervisor, &status, 0), supervisor);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
}

TEST(Limits, TheEnvironmentOfTheOptionsGoesOverTheDevicesOwn) {
  DeviceEntry entry;
  entry.id = "fake";
  entry.environment = {{"FAKE_DRIVER", "llvmpipe"}};
  Worker worker(entry, {.shader_root = "shaders", .environment = {{"FAKE_DRIVER", "another"}}});
  ASSERT_TRUE(worker.info());
  EXPECT_EQ(worker.info()->identity.driver, "another");
}

TEST(Limits, APhaseIsKnownByItsProgress) {
  EXPECT_EQ(phaseOf("compile gbuffer.frag"), JobPhase::kCompile);
  EXPECT_EQ(phaseOf("build trace_hiz"), JobPhase::kCompile);
  EXPECT_EQ(phaseOf("draw trace_hiz"), JobPhase::kRun);
  EXPECT_EQ(phaseOf("read back"), JobPhase::kOther);
}

}  // namespace ssrkit
