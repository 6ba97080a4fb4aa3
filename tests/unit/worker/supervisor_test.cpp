#include "worker/supervisor.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cerrno>
#include <csignal>
#include <thread>

#include "fake_worker.h"
#include "samples.h"

namespace ssrkit {

namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

bool processIsGone(const std::string& progress) {  // "pid 123"
  const pid_t pid = std::stoi(progress.substr(4));
  return ::kill(pid, 0) != 0 && errno == ESRCH;
}

}  // namespace

TEST(Supervisor, AResultArrivesBitForBit) {
  Worker worker = fakeWorker();
  const JobOutcome outcome = worker.run(fakeJob("sample"), kAmple);
  ASSERT_TRUE(std::holds_alternative<JobResult>(outcome));
  EXPECT_TRUE(sameBits(std::get<JobResult>(outcome), sampleResult()));
}

TEST(Supervisor, TheWorkerReceivesTheJobBitForBit) {
  Worker worker = fakeWorker();
  Job job = sampleJob();
  job.id = "check job";
  EXPECT_EQ(note(worker.run(job, kAmple)), "same");
  job.gbuffer["dist_view"].data[4] = 0.0F;  // was -0
  EXPECT_EQ(note(worker.run(job, kAmple)), "different");
}

TEST(Supervisor, TheDevicesEnvironmentAndTheShaderRootReachTheWorker) {
  Worker worker = fakeWorker();
  const Expected<DeviceInfo> info = worker.info();
  ASSERT_TRUE(info);
  EXPECT_EQ(info->identity.id, "fake");
  EXPECT_EQ(info->identity.driver, "llvmpipe");
  EXPECT_EQ(info->identity.version, "some/shaders");
  EXPECT_EQ(info->traits.loop_cap, 65535U);
}

TEST(Supervisor, AnErrorOfTheJobIsReturnedAndTheWorkerGoesOn) {
  Worker worker = fakeWorker();
  const std::string pid = worker.info()->identity.cpu;
  const JobOutcome outcome = worker.run(fakeJob("error"), kAmple);
  ASSERT_TRUE(std::holds_alternative<Error>(outcome));
  EXPECT_EQ(sentence(std::get<Error>(outcome)), "a:1:2: could not draw: no such thing");
  EXPECT_EQ(std::get<Error>(outcome).kind, ErrorKind::kInput);
  EXPECT_EQ(note(worker.run(fakeJob("pid"), kAmple)), pid);
}

TEST(Supervisor, AnExceptionInTheWorkerIsAnErrorAndTheWorkerGoesOn) {
  Worker worker = fakeWorker();
  const std::string pid = worker.info()->identity.cpu;
  EXPECT_EQ(sentence(std::get<Error>(worker.run(fakeJob("throw"), kAmple))),
            "could not run 'throw' on 'fake': an unforeseen failure: thrown on purpose");
  EXPECT_EQ(std::get<Error>(worker.run(fakeJob("bad_alloc"), kAmple)).problem, "memory ran out");
  EXPECT_EQ(note(worker.run(fakeJob("pid"), kAmple)), pid);
}

TEST(Supervisor, ASegmentationFaultIsACrashWithTheLastProgressAndTheNextJobSucceeds) {
  Worker worker = fakeWorker();
  const WorkerDeath death = deathOf(worker.run(fakeJob("segv"), kAmple));
  EXPECT_EQ(death.kind, WorkerDeath::Kind::kCrash);
  EXPECT_EQ(death.signal, SIGSEGV);
  EXPECT_EQ(death.last_progress.substr(0, 4), "pid ");
  EXPECT_TRUE(processIsGone(death.last_progress));
  EXPECT_TRUE(std::holds_alternative<JobResult>(worker.run(fakeJob("sample"), kAmple)));
}

// One that sleeps and one that spins.
class HungWorker : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Supervisor, HungWorker, testing::Values("sleep", "spin"),
                         [](const auto& hung) { return std::string(hung.param); });

TEST_P(HungWorker, IsKilledWithinHalfASecondOfTheWallLimit) {
  Worker worker = fakeWorker();
  ASSERT_TRUE(worker.info());
  const auto start = std::chrono::steady_clock::now();
  const WorkerDeath death = deathOf(worker.run(fakeJob(GetParam()), {milliseconds(300), seconds(60)}));
  const auto elapsed = std::chrono::steady_clock::now() - start;
  EXPECT_GE(elapsed, milliseconds(300));
  EXPECT_LT(elapsed, milliseconds(800));
  EXPECT_EQ(death.kind, WorkerDeath::Kind::kTimeout);
  EXPECT_EQ(death.signal, SIGKILL);
  EXPECT_TRUE(processIsGone(death.last_progress));
  EXPECT_EQ(note(worker.run(fakeJob("alive"), kAmple)), "alive");
}

TEST(Supervisor, TheCpuLimitIsATimeoutBySigxcpuAndCountsFromTheJobsStart) {
  Worker worker = fakeWorker();
  EXPECT_EQ(note(worker.run(fakeJob("burn 0.8 s"), {milliseconds(60000), seconds(2)})), "burnt");
  EXPECT_EQ(note(worker.run(fakeJob("burn 0.8 s"), {milliseconds(60000), seconds(2)})), "burnt");
  EXPECT_EQ(note(worker.run(fakeJob("burn 0.8 s"), {milliseconds(60000), seconds(2)})), "burnt");
  const WorkerDeath death = deathOf(worker.run(fakeJob("spin"), {milliseconds(60000), seconds(1)}));
  EXPECT_EQ(death.kind, WorkerDeath::Kind::kTimeout);
  EXPECT_EQ(death.signal, SIGXCPU);
  EXPECT_TRUE(processIsGone(death.last_progress));
}

// Each of these leaves the protocol instead of answering.
struct Departure {
  std::string job;
  const char* last_line;
};
class DepartedWorker : public testing::TestWithParam<Departure> {};
INSTANTIATE_TEST_SUITE_P(
    Supervisor, DepartedWorker,
    testing::Values(Departure{"garbage", "the worker sent bytes that are no message\n"},
                    Departure{"short_packet", "the worker sent bytes that are no message\n"},
                    Departure{"damaged_result", "the worker sent bytes that are no message\n"},
                    Departure{"shut_down", "the worker closed its socket and went on\n"},
                    Departure{"exit", "the worker exited with code 0 before it answered\n"}),
    [](const auto& departed) { return departed.param.job; });

TEST_P(DepartedWorker, IsACrashWithoutASignalThatSaysHow) {
  Worker worker = fakeWorker();
  const WorkerDeath death = deathOf(worker.run(fakeJob(GetParam().job), kAmple));
  EXPECT_EQ(death.kind, WorkerDeath::Kind::kCrash);
  EXPECT_EQ(death.signal, 0);
  EXPECT_EQ(death.stderr_tail, GetParam().last_line);
  EXPECT_TRUE(processIsGone(death.last_progress));
  EXPECT_EQ(note(worker.run(fakeJob("alive"), kAmple)), "alive");
}

TEST(Supervisor, AGigabyteOnStderrIsDrainedAndNotKept) {
  Worker worker = fakeWorker();
  rusage before = {};
  ::getrusage(RUSAGE_SELF, &before);
  EXPECT_EQ(note(worker.run(fakeJob("flood"), kAmple)), "done");
  rusage after = {};
  ::getrusage(RUSAGE_SELF, &after);
  EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 16 * 1024);  // KiB
}

TEST(Supervisor, TheLast64KiBOfStderrComeWithTheDeath) {
  Worker worker = fakeWorker();
  const WorkerDeath death = deathOf(worker.run(fakeJob("flood and abort"), kAmple));
  EXPECT_EQ(death.signal, SIGABRT);
  EXPECT_EQ(death.stderr_tail.size(), 65536U);
  EXPECT_TRUE(death.stderr_tail.ends_with("x\nthe last words\n"));
}

TEST(Supervisor, StderrOfAnEarlierJobIsNotBlamedOnALaterOne) {
  Worker worker = fakeWorker();
  EXPECT_EQ(note(worker.run(fakeJob("mutter"), kAmple)), "muttered");
  EXPECT_EQ(deathOf(worker.run(fakeJob("segv"), kAmple)).stderr_tail, "");
}

TEST(Supervisor, AWorkerThatDiedBetweenTwoJobsIsReplacedWithoutAWord) {
  Worker worker = fakeWorker();
  EXPECT_EQ(note(worker.run(fakeJob("die later"), kAmple)), "fine so far");
  std::this_thread::sleep_for(milliseconds(500));
  EXPECT_EQ(note(worker.run(fakeJob("alive"), kAmple)), "alive");
}

TEST(Supervisor, AWorkerThatHasGrownIsReplacedBeforeItsNextJob) {
  Worker worker = fakeWorker();
  const std::string pid = worker.info()->identity.cpu;
  EXPECT_EQ(note(worker.run(fakeJob("pid"), kAmple)), pid);
  EXPECT_EQ(note(worker.run(fakeJob("grow"), kAmple)), pid);
  const std::string next = note(worker.run(fakeJob("pid"), kAmple));
  EXPECT_NE(next, "");
  EXPECT_NE(next, pid);
  EXPECT_EQ(note(worker.run(fakeJob("pid"), kAmple)), next);
}

TEST(Supervisor, AWorkerIsReplacedForWhatItGrowsAfterItsFirstJobAndNotForWhatThatTakes) {
  Worker worker = fakeWorker();
  const std::string pid = note(worker.run(fakeJob("grow a little"), kAmple));
  EXPECT_EQ(note(worker.run(fakeJob("grow a little"), kAmple)), pid);
  EXPECT_EQ(note(worker.run(fakeJob("grow"), kAmple)), pid);
  const std::string next = note(worker.run(fakeJob("pid"), kAmple));
  EXPECT_NE(next, pid);
  EXPECT_EQ(note(worker.run(fakeJob("grow a little"), kAmple)), next);
  EXPECT_NE(note(worker.run(fakeJob("pid"), kAmple)), next);
}

TEST(Supervisor, AnExecutableThatCannotBeRunIsAnErrorThatNamesIt) {
  WorkerOptions options;
  options.executable = "/nowhere/ssrkit";
  DeviceEntry entry;
  entry.id = "fake";
  Worker worker(entry, options);
  const Expected<DeviceInfo> info = worker.info();
  ASSERT_FALSE(info);
  EXPECT_EQ(sentence(info.error()),
            "could not start a worker process: /nowhere/ssrkit: No such file or directory");
  EXPECT_TRUE(std::holds_alternative<Error>(worker.run(fakeJob("sample"), kAmple)));
}

TEST(Supervisor, AnAbsentDeviceIsItsOwnError) {
  Worker worker = fakeWorker("fake-absent");
  const Expected<DeviceInfo> info = worker.info();
  ASSERT_FALSE(info);
  EXPECT_EQ(sentence(info.error()), "could not start the device 'fake-absent': there is no such driver");
  EXPECT_EQ(info.error().kind, ErrorKind::kSetup);
}

TEST(Supervisor, ADeviceThatDiesAtTheStartIsAnErrorWithItsSignalAndLastLines) {
  Worker worker = fakeWorker("fake-crash");
  const Expected<DeviceInfo> info = worker.info();
  ASSERT_FALSE(info);
  EXPECT_EQ(info.error().problem,
            "its worker process died of signal 11 (Segmentation fault) in 'create the fake'");
  EXPECT_EQ(info.error().reasons, std::vector<std::string>{"about to crash"});
}

TEST(Supervisor, ADeviceThatHangsAtTheStartIsAnErrorAtTheStartLimit) {
  Worker worker = fakeWorker("fake-hang");  // 1.5 s
  const auto start = std::chrono::steady_clock::now();
  const Expected<DeviceInfo> info = worker.info();
  EXPECT_LT(std::chrono::steady_clock::now() - start, milliseconds(2000));
  ASSERT_FALSE(info);
  EXPECT_EQ(info.error().problem, "its worker process gave no answer in time in 'create the fake'");
}

TEST(Supervisor, AProgramThatIsNoWorkerIsAnError) {
  Worker worker = fakeWorker("fake-mute");
  const Expected<DeviceInfo> info = worker.info();
  ASSERT_FALSE(info);
  EXPECT_EQ(info.error().reasons,
            std::vector<std::string>{"the worker exited with code 0 before it answered"});
}

TEST(Supervisor, AnExceptionAtTheStartIsAnError) {
  Worker worker = fakeWorker("fake-throw");
  const Expected<DeviceInfo> info = worker.info();
  ASSERT_FALSE(info);
  EXPECT_EQ(info.error().problem, "an unforeseen failure: thrown at the start");
}

}  // namespace ssrkit
