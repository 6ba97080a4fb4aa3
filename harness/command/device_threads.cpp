#include "command/device_threads.h"

#include <fmt/format.h>

#include <charconv>

namespace ssrkit {

Expected<DeviceEntry> deviceWithThreads(const std::string& name) {
  constexpr int kMostThreads = 64;
  const std::size_t at = name.find('@');
  const auto entry = findDevice(name.substr(0, at));
  if (!entry || at == std::string::npos) {
    return entry ? Expected<DeviceEntry>(**entry) : tl::make_unexpected(entry.error());
  }
  int threads = 0;
  const char* const end = name.data() + name.size();
  const auto [rest, error] = std::from_chars(name.data() + at + 1, end, threads);
  if (error != std::errc() || rest != end || threads < 1 || threads > kMostThreads) {
    return inputError(fmt::format("find the device '{}'", name),
                      fmt::format("what follows '@' is no number of threads from 1 to {}", kMostThreads), {},
                      "write for example vk-lavapipe@2");
  }
  DeviceEntry with_threads = **entry;
  with_threads.environment.emplace_back("LP_NUM_THREADS", std::to_string(threads));
  return with_threads;
}

bool isVulkanDevice(const std::string& name) {
  const auto entry = deviceWithThreads(name);
  return entry && entry->target == ShaderTarget::kVulkan;
}

}  // namespace ssrkit
