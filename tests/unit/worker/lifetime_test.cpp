// What is left of workers: nothing.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <future>
#include <thread>

#include "base/owned_fd.h"
#include "base/process_groups.h"
#include "fake_worker.h"
#include "samples.h"

namespace ssrkit {

namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

std::size_t openDescriptorCount() {
  const std::filesystem::directory_iterator list("/proc/self/fd");
  return static_cast<std::size_t>(std::distance(begin(list), end(list)));
}

bool hasNoChild() {
  return ::waitid(P_ALL, 0, nullptr, WEXITED | WNOHANG | WNOWAIT) != 0 && errno == ECHILD;
}

// Gone, or a zombie that its new parent has yet to collect.
bool hasEnded(pid_t pid) {
  std::ifstream status("/proc/" + std::to_string(pid) + "/stat");
  std::string line;
  return !std::getline(status, line) || line.find(") Z") != std::string::npos;
}

template <class Condition>
bool becomesTrue(const Condition& condition, milliseconds limit) {
  const auto deadline = std::chrono::steady_clock::now() + limit;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > deadline) {
      return false;
    }
    std::this_thread::sleep_for(milliseconds(5));
  }
  return true;
}

class Spinning {  // a job that tells its process number by a file
 public:
  Spinning() : job_(fakeJob("spin")) {
    job_.scene_file = std::filesystem::temp_directory_path() /
                      ("ssrkit-worker-test-" + std::to_string(::getpid()) + ".pid");
    std::filesystem::remove(job_.scene_file);
  }
  ~Spinning() { std::filesystem::remove(job_.scene_file); }
  Spinning(const Spinning&) = delete;
  Spinning& operator=(const Spinning&) = delete;

  [[nodiscard]] const Job& job() const { return job_; }
  [[nodiscard]] pid_t pid() const {
    pid_t pid = 0;
    const auto told = [&] {
      std::ifstream file(job_.scene_file);
      return static_cast<bool>(file >> pid) && file.peek() == '\n';
    };
    EXPECT_TRUE(becomesTrue(told, milliseconds(20000)));
    return pid;
  }

 private:
  Job job_;
};

}  // namespace

TEST(Lifetime, TheDestructorLeavesNoProcessAndNoDescriptor) {
  const std::size_t before = openDescriptorCount();
  pid_t pid = 0;
  {
    Worker worker = fakeWorker();
    pid = std::stoi(worker.info()->identity.cpu);
    EXPECT_FALSE(hasNoChild());
  }
  EXPECT_TRUE(hasNoChild());
  EXPECT_NE(::kill(pid, 0), 0);
  EXPECT_EQ(openDescriptorCount(), before);
}

TEST(Lifetime, AWellBehavedWorkerIsNotWaitedForLongerThanItNeeds) {
  auto worker = std::make_unique<Worker>(fakeWorker());
  ASSERT_TRUE(worker->info());
  const auto start = std::chrono::steady_clock::now();
  worker.reset();
  EXPECT_LT(std::chrono::steady_clock::now() - start, milliseconds(500));
}

TEST(Lifetime, AWorkerAtRestHasNoProcessUntilItsNextJob) {
  Worker worker = fakeWorker();
  worker.rest();  // before its first
  const std::string pid = worker.info()->identity.cpu;
  worker.rest();
  EXPECT_TRUE(hasNoChild());
  EXPECT_EQ(worker.info()->identity.cpu, pid);
  EXPECT_TRUE(hasNoChild());
  const JobOutcome outcome = worker.run(fakeJob("sample"), kAmple);
  EXPECT_TRUE(std::holds_alternative<JobResult>(outcome));
  EXPECT_FALSE(hasNoChild());
}

TEST(Lifetime, DeathsOfEveryKindLeaveNoProcessAndNoDescriptor) {
  const std::size_t before = openDescriptorCount();
  {
    Worker worker = fakeWorker();
    for (const char* const id : {"segv", "garbage", "exit", "short_packet", "damaged_result"}) {
      EXPECT_TRUE(std::holds_alternative<WorkerDeath>(worker.run(fakeJob(id), kAmple))) << id;
    }
    EXPECT_TRUE(
        std::holds_alternative<WorkerDeath>(worker.run(fakeJob("sleep"), {milliseconds(50), seconds(9)})));
    EXPECT_FALSE(fakeWorker("fake-crash").info());
    EXPECT_FALSE(fakeWorker("fake-absent").info());
    EXPECT_TRUE(hasNoChild());
  }
  EXPECT_EQ(openDescriptorCount(), before);
}

TEST(Lifetime, TwoHundredJobsLeakNoDescriptorOnEitherSide) {
  Worker worker = fakeWorker();
  const std::string in_worker = note(worker.run(fakeJob("descriptors"), kAmple));
  const std::size_t in_supervisor = openDescriptorCount();
  Job job = sampleJob();
  for (int i = 0; i < 200; ++i) {
    job.id = i % 2 == 0 ? "sample" : "check job";
    ASSERT_TRUE(std::holds_alternative<JobResult>(worker.run(job, kAmple)));
  }
  EXPECT_EQ(openDescriptorCount(), in_supervisor);
  EXPECT_EQ(note(worker.run(fakeJob("descriptors"), kAmple)), in_worker);
}

TEST(Lifetime, NoDescriptorOfTheSupervisorOrOfASiblingReachesAWorker) {
  const OwnedFd inheritable(::open("/dev/null", O_RDONLY));  // no O_CLOEXEC, on purpose
  Worker first = fakeWorker();
  ASSERT_TRUE(first.info());
  Worker second = fakeWorker();
  // 4 is the memory of the job that asks.
  EXPECT_EQ(note(second.run(fakeJob("descriptors"), kAmple)), "0 1 2 3 4 ");
}

TEST(Lifetime, WorkersHaveTheirOwnGroupNoStandardInputAndNoCoreFiles) {
  Worker worker = fakeWorker();
  EXPECT_EQ(note(worker.run(fakeJob("limits"), kAmple)), "core 0 group true stdin /dev/null");
}

TEST(Lifetime, WorkersOfSeveralThreadsWorkAtOnceAndDieAlone) {
  const auto crash_and_recover = [](bool crashes) {
    Worker worker = fakeWorker();
    int good = 0;
    for (int i = 0; i < 10; ++i) {
      const JobOutcome outcome = worker.run(fakeJob(crashes && i % 3 == 0 ? "segv" : "sample"), kAmple);
      good += std::holds_alternative<JobResult>(outcome) ? 1 : 0;
    }
    return good;
  };
  auto a = std::async(std::launch::async, crash_and_recover, true);
  auto b = std::async(std::launch::async, crash_and_recover, false);
  auto c = std::async(std::launch::async, crash_and_recover, true);
  EXPECT_EQ(a.get(), 6);
  EXPECT_EQ(b.get(), 10);
  EXPECT_EQ(c.get(), 6);
  EXPECT_TRUE(hasNoChild());
}

TEST(Lifetime, AWorkerOutlivesTheThreadThatStartedIt) {
  Worker worker = fakeWorker();
  std::string pid;
  std::thread([&] { pid = worker.info()->identity.cpu; }).join();
  std::this_thread::sleep_for(milliseconds(100));
  EXPECT_EQ(note(worker.run(fakeJob("pid"), kAmple)), pid);
}

TEST(Lifetime, KillAllGroupsEndsTheJobsOfEveryWorkerAtOnce) {
  const Spinning spinning;
  Worker busy = fakeWorker();
  Worker idle = fakeWorker();
  const std::string idle_pid = idle.info()->identity.cpu;
  auto outcome = std::async(std::launch::async, [&] { return busy.run(spinning.job(), kAmple); });
  static_cast<void>(spinning.pid());
  killAllGroups();
  const JobOutcome ended = outcome.get();
  ASSERT_TRUE(std::holds_alternative<WorkerDeath>(ended));
  EXPECT_EQ(std::get<WorkerDeath>(ended).kind, WorkerDeath::Kind::kCrash);
  EXPECT_EQ(std::get<WorkerDeath>(ended).signal, SIGKILL);
  EXPECT_NE(note(idle.run(fakeJob("pid"), kAmple)), idle_pid);
}

TEST(Lifetime, KillAllGroupsSparesChildrenThatAreNotRemembered) {
  ASSERT_TRUE(fakeWorker().info());  // it has ended, and is forgotten
  const pid_t stranger = ::fork();
  if (stranger == 0) {
    ::pause();
    std::_Exit(0);
  }
  killAllGroups();
  std::this_thread::sleep_for(milliseconds(50));
  EXPECT_EQ(::waitpid(stranger, nullptr, WNOHANG), 0);
  ::kill(stranger, SIGKILL);
  EXPECT_EQ(::waitpid(stranger, nullptr, 0), stranger);
}

TEST(Lifetime, AWorkerInTheMiddleOfAJobEndsWhenItsSupervisorIsKilled) {
  const Spinning spinning;
  const pid_t supervisor = ::fork();
  if (supervisor == 0) {
    Worker worker = fakeWorker();
    static_cast<void>(worker.run(spinning.job(), kAmple));
    std::_Exit(0);
  }
  const pid_t pid = spinning.pid();
  EXPECT_FALSE(hasEnded(pid));
  ::kill(supervisor, SIGKILL);
  ::waitpid(supervisor, nullptr, 0);
  EXPECT_TRUE(becomesTrue([&] { return hasEnded(pid); }, milliseconds(5000)));
}

}  // namespace ssrkit
