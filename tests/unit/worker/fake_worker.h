// This test program, started again as a worker: its device draws nothing and fails on demand.
#pragma once

#include <string>

#include "worker/supervisor.h"

namespace ssrkit {

// What to do is the job's id, see fake_worker.cpp; at the start it is the device's: "fake", "fake-absent",
// "fake-crash", "fake-hang", "fake-mute", "fake-throw".
[[nodiscard]] int fakeWorkerMain(const std::string& device_id, int fd);

[[nodiscard]] Worker fakeWorker(const std::string& device_id = "fake");
[[nodiscard]] Job fakeJob(const std::string& id);

}  // namespace ssrkit
