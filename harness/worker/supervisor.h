// Runs jobs in a child process for each device. The supervisor itself never loads GL or Vulkan.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <variant>

#include "device/registry.h"
#include "frame/job.h"

namespace ssrkit {

struct JobLimits {
  std::chrono::milliseconds wall{120000};
  std::chrono::seconds cpu{240};
};

// The worker died of a signal or stopped answering in the middle of a job.
struct WorkerDeath {
  enum class Kind { kCrash, kTimeout };
  Kind kind = Kind::kCrash;
  int signal = 0;              // that ended it; SIGXCPU for the CPU limit
  std::string last_progress;   // what it had begun
  std::string stderr_tail;     // the last lines it wrote
};

using JobOutcome = std::variant<JobResult, Error, WorkerDeath>;

struct DeviceInfo {
  DeviceIdentity identity;
  DeviceTraits traits;
};

// One device's worker. It is started at the first call, and again after a death.
class Worker {
 public:
  explicit Worker(const DeviceEntry& entry);
  ~Worker();
  Worker(Worker&&) noexcept;
  Worker& operator=(Worker&&) noexcept;

  // Identity and traits; an Error when the device is absent or its worker dies at the start.
  [[nodiscard]] Expected<DeviceInfo> info();

  // Blocks until the result, an error or a death.
  [[nodiscard]] JobOutcome run(const Job& job, const JobLimits& limits);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// The worker process: `ssrkit __worker DEVICE`, speaks the protocol on `fd` until it is closed. Returns the exit code.
[[nodiscard]] int workerMain(const std::string& device_id, int fd);

}  // namespace ssrkit
