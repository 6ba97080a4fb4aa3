// Runs jobs in a child process for each device. The supervisor itself never loads GL or Vulkan.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "device/registry.h"
#include "device/traits.h"
#include "frame/job.h"
#include "worker/job_limits.h"
#include "worker/worker_death.h"

namespace ssrkit {

using JobOutcome = std::variant<JobResult, Error, WorkerDeath>;

struct DeviceInfo {
  DeviceIdentity identity;
  DeviceTraits traits;
  std::int64_t create_ns = 0;  // wall time of making the device: driver, context
};

struct WorkerOptions {
  std::filesystem::path shader_root;                    // where the start-up probe finds its shaders
  std::filesystem::path executable = "/proc/self/exe";  // called as `EXECUTABLE __worker DEVICE`
  std::chrono::milliseconds start_limit{60000};         // from the start to the device's identity and traits
  std::vector<std::pair<std::string, std::string>> environment = {};  // set over the device's own
};

// A worker's process that holds more than this, or so much more than after its first job, is replaced before
// its next one: a driver keeps the code of every shader that it was ever given, and what it frees of a scene
// does not all go back.
inline constexpr std::int64_t kRenewAboveBytes = std::int64_t{384} << 20;
inline constexpr std::int64_t kRenewGrownBytes = std::int64_t{96} << 20;

// One device's worker. It is started at the first call, and again after a death, a rest, or when it has
// grown. Different Workers may be used from different threads at once; one Worker from one thread at a time.
//
// SSRKIT_FAULT makes a worker fail on purpose (fault.h).
class Worker {
 public:
  Worker(const DeviceEntry& entry, WorkerOptions options);
  ~Worker();
  Worker(Worker&&) noexcept;
  Worker& operator=(Worker&&) noexcept;

  // Identity and traits; an Error when the device is absent or its worker dies at the start.
  [[nodiscard]] Expected<DeviceInfo> info();

  // Blocks until the result, an error or a death. A worker that cannot be started is an Error.
  [[nodiscard]] JobOutcome run(const Job& job, const JobLimits& limits);

  // Ends the process until the next job, which starts another. What info() said stays known.
  void rest();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// The worker process: `ssrkit __worker DEVICE`, speaks the protocol on `fd` (3) until it is closed. Returns
// the exit code.
[[nodiscard]] int workerMain(const std::string& device_id, int fd);

}  // namespace ssrkit
