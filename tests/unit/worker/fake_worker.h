// This test program, started again as a worker: its device draws nothing and fails on demand.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "worker/supervisor.h"

namespace ssrkit {

// What to do is the job's id, see fake_worker.cpp; at the start it is the device's: "fake", "fake-absent",
// "fake-crash", "fake-hang", "fake-mute", "fake-throw".
[[nodiscard]] int fakeWorkerMain(const std::string& device_id, int fd);

[[nodiscard]] Worker fakeWorker(const std::string& device_id = "fake");
[[nodiscard]] Job fakeJob(const std::string& id);

inline const JobLimits kAmple{std::chrono::milliseconds(60000), std::chrono::seconds(60)};

// The first note of the result; empty without one.
inline std::string note(const JobOutcome& outcome) {
  const auto* const result = std::get_if<JobResult>(&outcome);
  return result && !result->notes.empty() ? result->notes[0] : "";
}

inline WorkerDeath deathOf(JobOutcome outcome) {
  auto* const death = std::get_if<WorkerDeath>(&outcome);
  EXPECT_NE(death, nullptr);
  return death ? *death : WorkerDeath{};
}

}  // namespace ssrkit
