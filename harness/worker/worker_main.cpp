#include "device/pass_clock.h"
#include "device/registry.h"
#include "device/traits.h"
#include "frame/run_job.h"
#include "worker/serve.h"

namespace ssrkit {

namespace {

// The device, and what keeps its programs and scenes between jobs. The runner goes first.
struct OpenDevice {
  std::unique_ptr<Device> device;
  std::unique_ptr<JobRunner> runner;
};

Expected<DeviceInfo> open(OpenDevice& open_device, const std::string& device_id,
                          const std::filesystem::path& shader_root, const Progress& progress) {
  const Expected<const DeviceEntry*> entry = findDevice(device_id);
  if (!entry) {
    return tl::make_unexpected(entry.error());
  }
  progress("create the device");
  const PassClock clock;
  Expected<std::unique_ptr<Device>> device = (*entry)->create();
  const std::int64_t create_ns = clock.elapsed().wall_ns;
  if (!device) {
    return tl::make_unexpected(device.error());
  }
  progress("probe its traits");
  const Expected<DeviceTraits> traits = probeTraits(**device, (*entry)->target, shader_root);
  if (!traits) {
    return tl::make_unexpected(traits.error());
  }
  open_device.device = std::move(*device);
  open_device.runner = std::make_unique<JobRunner>(*open_device.device, (*entry)->target);
  return DeviceInfo{open_device.device->identity(), *traits, create_ns};
}

}  // namespace

int workerMain(const std::string& device_id, int fd) {
  OpenDevice open_device;
  const WorkerRole role{
      [&](const std::filesystem::path& shader_root, const Progress& progress) {
        return open(open_device, device_id, shader_root, progress);
      },
      [&](const Job& job, const Progress& progress) { return open_device.runner->run(job, progress); }};
  return serve(device_id, fd, role);
}

}  // namespace ssrkit
