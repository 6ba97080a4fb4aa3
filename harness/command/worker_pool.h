// The workers of a run: one for each device, and one more for each environment that a device is driven in.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "worker/supervisor.h"

namespace ssrkit {

// Variables over the device's own.
using Environment = std::vector<std::pair<std::string, std::string>>;

class WorkerPool {
 public:
  // Starts none of them. Devices as deviceWithThreads names them; the options' environment is every worker's.
  // Fails on a device that is not known.
  [[nodiscard]] Expected<void> create(const std::vector<std::string>& devices, WorkerOptions options);

  // One of the pool's devices, in a process of its own for each environment: drivers read theirs once, when
  // they are loaded.
  [[nodiscard]] Worker& at(const std::string& device, const Environment& environment);

  // Identity and traits of every device; the first that is absent is an error.
  [[nodiscard]] Expected<std::map<std::string, DeviceInfo>> infos();

  // Ends every process until its next job.
  void rest();

 private:
  WorkerOptions options_;
  std::map<std::string, Worker> workers_;
  std::map<std::pair<std::string, Environment>, Worker> in_environments_;
};

}  // namespace ssrkit
