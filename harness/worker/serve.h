// The worker's side of the protocol, apart from what a worker does: tests serve with devices of their own.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "frame/job.h"
#include "frame/run_job.h"
#include "worker/supervisor.h"

namespace ssrkit {

struct WorkerRole {
  std::function<Expected<DeviceInfo>(const std::filesystem::path& shader_root, const Progress&)> start;
  std::function<Expected<JobResult>(const Job&, const Progress&)> run;
};

// The exit code of a worker whose socket was closed while it was at work.
inline constexpr int kAbandoned = 4;

// Answers on the socket `fd` until the supervisor closes it, one job at a time; exceptions become errors.
// When the supervisor goes away in the middle of a job, the process ends by itself within two seconds.
// Returns the exit code.
[[nodiscard]] int serve(const std::string& device_id, int fd, const WorkerRole& role);

}  // namespace ssrkit
