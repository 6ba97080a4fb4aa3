// Jobs, results, errors and identities as the payloads of messages, every field and every bit of it.
#pragma once

#include <chrono>
#include <filesystem>

#include "base/error.h"
#include "frame/job.h"
#include "worker/message.h"
#include "worker/supervisor.h"

namespace ssrkit {

struct LimitedJob {
  Job job;
  std::chrono::seconds cpu_limit{0};
};

// Packing fails only when memory runs out.
[[nodiscard]] Expected<Payload> packStart(const std::filesystem::path& shader_root);
[[nodiscard]] Expected<Payload> packInfo(const DeviceInfo& info);
[[nodiscard]] Expected<Payload> packJob(const Job& job, std::chrono::seconds cpu_limit);
[[nodiscard]] Expected<Payload> packResult(JobResult result);
[[nodiscard]] Expected<Payload> packError(const Error& error);

// Nothing when the payload is not what the function above writes: a size, count or code that cannot be true.
// The peer may have been corrupted by its driver.
[[nodiscard]] std::optional<std::filesystem::path> unpackStart(const Payload& payload);
[[nodiscard]] std::optional<DeviceInfo> unpackInfo(const Payload& payload);
[[nodiscard]] std::optional<LimitedJob> unpackJob(const Payload& payload);
[[nodiscard]] std::optional<JobResult> unpackResult(const Payload& payload);
[[nodiscard]] std::optional<Error> unpackError(const Payload& payload);

}  // namespace ssrkit
