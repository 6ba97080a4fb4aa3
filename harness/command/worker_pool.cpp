#include "command/worker_pool.h"

#include <future>

#include "base/check.h"
#include "command/device_threads.h"

namespace ssrkit {

Expected<void> WorkerPool::create(const std::vector<std::string>& devices, WorkerOptions options) {
  options_ = std::move(options);
  for (const std::string& device : devices) {
    const auto entry = deviceWithThreads(device);
    if (!entry) {
      return tl::make_unexpected(entry.error());
    }
    workers_.emplace(device, Worker(*entry, options_));
  }
  return {};
}

Worker& WorkerPool::at(const std::string& device, const Environment& environment) {
  if (environment.empty()) {
    return workers_.at(device);
  }
  const std::pair key{device, environment};
  if (const auto found = in_environments_.find(key); found != in_environments_.end()) {
    return found->second;
  }
  const auto entry = deviceWithThreads(device);
  SSRKIT_CHECK(entry.has_value());
  WorkerOptions options = options_;
  options.environment.insert(options.environment.end(), environment.begin(), environment.end());
  return in_environments_.emplace(key, Worker(*entry, std::move(options))).first->second;
}

Expected<std::map<std::string, DeviceInfo>> WorkerPool::infos() {
  std::map<std::string, std::future<Expected<DeviceInfo>>> starting;
  for (auto& [id, worker] : workers_) {
    starting.emplace(id,
                     std::async(std::launch::async, [&worker_ref = worker] { return worker_ref.info(); }));
  }
  std::map<std::string, DeviceInfo> infos;
  for (auto& [id, future] : starting) {
    auto info = future.get();
    if (!info) {
      return tl::make_unexpected(info.error());
    }
    infos.emplace(id, std::move(*info));
  }
  return infos;
}

void WorkerPool::rest() {
  for (auto& [id, worker] : workers_) {
    worker.rest();
  }
  for (auto& [key, worker] : in_environments_) {
    worker.rest();
  }
}

}  // namespace ssrkit
