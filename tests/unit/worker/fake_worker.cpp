#include "fake_worker.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <csignal>
#include <ctime>
#include <fstream>
#include <map>
#include <stdexcept>
#include <thread>

#include "samples.h"
#include "worker/message.h"
#include "worker/serve.h"
#include "worker/wire.h"

namespace ssrkit {

namespace {

constexpr int kSocket = 3;

[[noreturn]] void sleepForEver() {
  while (true) {
    ::pause();
  }
}

[[noreturn]] void spinForEver() {
  volatile bool spinning = true;
  while (spinning) {
  }
  std::abort();
}

[[noreturn]] void writeToForbiddenMemory() {
  std::signal(SIGSEGV, SIG_DFL);  // a sanitizer's handler would turn it into an exit
  void* const page = ::mmap(nullptr, 4096, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  *static_cast<volatile int*>(page) = 1;
  std::abort();
}

void writeStderr(std::size_t byte_count) {
  const std::string line(65535, 'x');
  for (std::size_t written = 0; written < byte_count; written += line.size() + 1) {
    std::fputs((line + "\n").c_str(), stderr);
  }
  std::fputs("the last words\n", stderr);
}

std::string openDescriptors() {
  std::string list;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
    const auto target = std::filesystem::read_symlink(entry.path()).string();
    if (target.find("/fd") == std::string::npos) {  // the iterator's own
      list += entry.path().filename().string() + " ";
    }
  }
  return list;
}

JobResult noted(const std::string& note) {
  JobResult result;
  result.notes = {note};
  return result;
}

std::string limitsInForce() {
  rlimit core = {};
  ::getrlimit(RLIMIT_CORE, &core);
  return fmt::format("core {} group {} stdin {}", core.rlim_cur, ::getpgrp() == ::getpid(),
                     std::filesystem::read_symlink("/proc/self/fd/0").string());
}

void sayItIsUp(const Job& job) {  // to a test that cannot see progress
  std::ofstream(job.scene_file) << ::getpid() << std::endl;
}

using Act = Expected<JobResult> (*)(const Job&);
const std::map<std::string, Act> kActs = {
    {"sample", [](const Job&) -> Expected<JobResult> { return sampleResult(); }},
    {"check job",
     [](const Job& job) -> Expected<JobResult> {
       Job sample = sampleJob();
       sample.id = job.id;
       return noted(sameBits(job, sample) ? "same" : "different");
     }},
    {"alive", [](const Job&) -> Expected<JobResult> { return noted("alive"); }},
    {"pid", [](const Job&) -> Expected<JobResult> { return noted(std::to_string(::getpid())); }},
    {"grow",
     [](const Job&) -> Expected<JobResult> {
       static const std::vector<char> kept(kRenewAboveBytes + 1, 'x');
       return noted(std::to_string(::getpid()));
     }},
    {"grow a little",
     [](const Job&) -> Expected<JobResult> {
       static const std::vector<char> kept(kRenewGrownBytes + 1, 'x');
       return noted(std::to_string(::getpid()));
     }},
    {"mutter",
     [](const Job&) -> Expected<JobResult> {
       std::fputs("a word of an earlier job\n", stderr);
       return noted("muttered");
     }},
    {"burn 0.8 s",
     [](const Job&) -> Expected<JobResult> {
       const std::clock_t end = std::clock() + CLOCKS_PER_SEC * 4 / 5;
       while (std::clock() < end) {
       }
       return noted("burnt");
     }},
    {"large",
     [](const Job& job) -> Expected<JobResult> {
       JobResult result;
       result.images["lit"] = Image(job.size, {"R", "G", "B", "A"});
       result.traces.resize(1);
       result.traces[0].record = RayRecord{job.size, std::vector<RayHit>(result.images["lit"].texelCount())};
       return result;
     }},
    {"error", [](const Job&) -> Expected<JobResult> { return inputError("draw", "no such thing", "a:1:2"); }},
    {"throw", [](const Job&) -> Expected<JobResult> { throw std::runtime_error("thrown on purpose"); }},
    {"bad_alloc", [](const Job&) -> Expected<JobResult> { throw std::bad_alloc(); }},
    {"segv", [](const Job&) -> Expected<JobResult> { writeToForbiddenMemory(); }},
    {"sleep", [](const Job&) -> Expected<JobResult> { sleepForEver(); }},
    {"spin",
     [](const Job& job) -> Expected<JobResult> {
       sayItIsUp(job);
       spinForEver();
     }},
    {"garbage",
     [](const Job&) -> Expected<JobResult> {
       static_cast<void>(::send(kSocket, "this is no message at all", 25, 0));
       sleepForEver();
     }},
    {"short_packet",
     [](const Job&) -> Expected<JobResult> {
       static_cast<void>(::send(kSocket, "SSRK", 4, 0));
       sleepForEver();
     }},
    {"damaged_result",
     [](const Job&) -> Expected<JobResult> {
       static_cast<void>(sendPayload(kSocket, MessageType::kResult, packError(Error{}).value()));
       sleepForEver();
     }},
    {"shut_down",
     [](const Job&) -> Expected<JobResult> {
       ::shutdown(kSocket, SHUT_RDWR);
       sleepForEver();
     }},
    {"exit", [](const Job&) -> Expected<JobResult> { std::_Exit(0); }},
    {"flood",
     [](const Job&) -> Expected<JobResult> {
       writeStderr(std::size_t{1} << 30);
       return noted("done");
     }},
    {"flood and abort",
     [](const Job&) -> Expected<JobResult> {
       writeStderr(std::size_t{8} << 20);
       std::signal(SIGABRT, SIG_DFL);
       std::abort();
     }},
    {"die later",
     [](const Job&) -> Expected<JobResult> {
       std::thread([] {
         std::this_thread::sleep_for(std::chrono::milliseconds(50));
         std::_Exit(9);
       }).detach();
       return noted("fine so far");
     }},
    {"descriptors", [](const Job&) -> Expected<JobResult> { return noted(openDescriptors()); }},
    {"limits", [](const Job&) -> Expected<JobResult> { return noted(limitsInForce()); }},
};

// Each within a limit of 600 ms, all of them not.
Expected<JobResult> drawFourTimes(const Progress& progress) {
  for (int i = 0; i < 4; ++i) {
    progress("draw pass " + std::to_string(i));
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  }
  return noted("drawn");
}

Expected<DeviceInfo> start(const std::string& device_id, const std::filesystem::path& shader_root) {
  if (device_id == "fake-absent") {
    return setupError("start the device 'fake-absent'", "there is no such driver");
  }
  if (device_id == "fake-crash") {
    std::fputs("about to crash\n", stderr);
    writeToForbiddenMemory();
  }
  if (device_id == "fake-hang") {
    sleepForEver();
  }
  if (device_id == "fake-throw") {
    throw std::runtime_error("thrown at the start");
  }
  const char* const variable = std::getenv("FAKE_DRIVER");
  DeviceInfo info;
  info.identity.id = device_id;
  info.identity.driver = variable ? variable : "";
  info.identity.version = shader_root.string();
  info.identity.cpu = std::to_string(::getpid());
  info.traits.loop_cap = 65535;
  return info;
}

}  // namespace

int fakeWorkerMain(const std::string& device_id, int fd) {
  const WorkerRole role{[&](const std::filesystem::path& shader_root, const Progress& progress) {
                          progress("create the fake");
                          return start(device_id, shader_root);
                        },
                        [](const Job& job, const Progress& progress) {
                          progress("read the scene");
                          progress("pid " + std::to_string(::getpid()));
                          if (job.id.starts_with("compile ") || job.id.starts_with("draw ")) {
                            progress(job.id);
                            sleepForEver();
                          }
                          if (job.id == "many draws") {
                            return drawFourTimes(progress);
                          }
                          return kActs.at(job.id)(job);
                        }};
  return device_id == "fake-mute" ? 0 : serve(device_id, fd, role);
}

Worker fakeWorker(const std::string& device_id) {
  DeviceEntry entry;
  entry.id = device_id;
  entry.environment = {{"FAKE_DRIVER", "llvmpipe"}};
  WorkerOptions options;
  options.shader_root = "some/shaders";
  options.start_limit = std::chrono::milliseconds(device_id == "fake-hang" ? 1500 : 20000);
  return Worker(entry, options);
}

Job fakeJob(const std::string& id) {
  Job job;
  job.id = id;
  return job;
}

}  // namespace ssrkit

int main(int argc, char** argv) {
  if (argc == 3 && std::string(argv[1]) == "__worker") {
    return ssrkit::fakeWorkerMain(argv[2], ssrkit::kSocket);
  }
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
