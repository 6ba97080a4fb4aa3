#include "worker/supervisor.h"

#include <poll.h>

#include <algorithm>
#include <array>

#include "base/check.h"
#include "worker/child_process.h"
#include "worker/message.h"
#include "worker/serve.h"
#include "worker/wire.h"
#include "worker/worker_death.h"

namespace ssrkit {

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

// For a worker that closes its socket: its threads' ends take a moment, on a busy machine more than a second.
constexpr milliseconds kGrace{5000};
constexpr milliseconds kLongestPoll{60000};
// A worker that never stops telling what it does gives no answer.
constexpr int kMostLateMessages = 4096;

}  // namespace

struct Worker::Impl {
  using Reply = std::variant<Message, WorkerDeath>;

  Impl(const DeviceEntry& entry, WorkerOptions worker_options)
      : device_id(entry.id), environment(entry.environment), options(std::move(worker_options)) {
    for (const auto& [name, value] : options.environment) {
      std::erase_if(environment, [&key = name](const auto& pair) { return pair.first == key; });
      environment.emplace_back(name, value);
    }
  }

  [[nodiscard]] bool hasGrown() const;
  Expected<void> ensureStarted();
  Expected<void> greet();
  JobOutcome run(const Job& job, const JobLimits& limits);
  Reply awaitReply(const JobLimits& limits);
  void watch(milliseconds most);
  WorkerDeath bury(WorkerDeath::Kind kind, milliseconds grace, const std::string& note);
  WorkerDeath buryForGarbage() {
    return bury(WorkerDeath::Kind::kCrash, milliseconds(0), "the worker sent bytes that are no message");
  }
  [[nodiscard]] tl::unexpected<Error> startFailure(const WorkerDeath& death) const;

  std::string device_id;
  std::vector<std::pair<std::string, std::string>> environment;
  WorkerOptions options;
  std::optional<ChildProcess> child;
  bool stderr_open = true;                            // of the child
  std::optional<std::int64_t> bytes_after_first_job;  // of the child
  std::optional<DeviceInfo> device;
  std::string last_progress;
};

bool Worker::Impl::hasGrown() const {
  const std::int64_t bytes = child->residentBytes();
  return bytes > kRenewAboveBytes || bytes - bytes_after_first_job.value_or(bytes) > kRenewGrownBytes;
}

Expected<void> Worker::Impl::ensureStarted() {
  // It may have died between two jobs; nothing is to be read then from one that is well.
  if (child && receiveMessage(child->socket(), false).state != Received::State::kNothingYet) {
    child.reset();
  }
  if (child && hasGrown()) {
    child->end(kGrace);
    child.reset();
  }
  if (child) {
    return {};
  }
  Expected<ChildProcess> started =
      ChildProcess::start({options.executable, {"__worker", device_id}, environment});
  if (!started) {
    return tl::make_unexpected(started.error());
  }
  child.emplace(std::move(*started));
  stderr_open = true;
  bytes_after_first_job.reset();
  Expected<void> greeted = greet();
  if (!greeted) {
    child.reset();
  }
  return greeted;
}

Expected<void> Worker::Impl::greet() {
  last_progress.clear();
  const Expected<Payload> start = packStart(options.shader_root);
  if (!start) {
    return tl::make_unexpected(start.error());
  }
  // A failure to send is a death, which awaitReply sees.
  static_cast<void>(sendPayload(child->socket(), MessageType::kStart, *start));
  const Reply reply = awaitReply({.wall = options.start_limit});
  if (const auto* const death = std::get_if<WorkerDeath>(&reply)) {
    return startFailure(*death);
  }
  const Message& message = std::get<Message>(reply);
  if (message.type == MessageType::kError) {
    if (std::optional<Error> error = unpackError(message.payload)) {
      return tl::make_unexpected(std::move(*error));
    }
  }
  if (message.type == MessageType::kHello) {
    if ((device = unpackInfo(message.payload))) {
      return {};
    }
  }
  return startFailure(buryForGarbage());
}

tl::unexpected<Error> Worker::Impl::startFailure(const WorkerDeath& death) const {
  auto failure = setupError("start the device '" + device_id + "'", describe(death), {},
                            "see that its driver's package is installed");
  failure.value().reasons = lastLines(death.stderr_tail);
  return failure;
}

JobOutcome Worker::Impl::run(const Job& job, const JobLimits& limits) {
  SSRKIT_CHECK_LE(1, limits.cpu.count());
  if (const Expected<void> started = ensureStarted(); !started) {
    return started.error();
  }
  last_progress.clear();
  child->drainStderr();
  child->clearStderrTail();
  const Expected<Payload> packed = packJob(job, limits.cpu);
  if (!packed) {
    return packed.error();
  }
  static_cast<void>(sendPayload(child->socket(), MessageType::kJob, *packed));
  Reply reply = awaitReply(limits);
  if (auto* const death = std::get_if<WorkerDeath>(&reply)) {
    return std::move(*death);
  }
  bytes_after_first_job = bytes_after_first_job.value_or(child->residentBytes());
  const Message& message = std::get<Message>(reply);
  if (message.type == MessageType::kResult) {
    if (std::optional<JobResult> result = unpackResult(message.payload)) {
      return std::move(*result);
    }
  }
  if (message.type == MessageType::kError) {
    if (std::optional<Error> error = unpackError(message.payload)) {
      return std::move(*error);
    }
  }
  return buryForGarbage();
}

// Keeps last_progress and the tail of stderr up to date until anything but progress arrives. This process may
// have been stopped for longer than the limit: what came meanwhile lies in the socket, and is read first.
Worker::Impl::Reply Worker::Impl::awaitReply(const JobLimits& limits) {
  const Clock::time_point end = Clock::now() + limits.wall;
  Clock::time_point deadline = end;
  int late_messages = 0;
  while (late_messages <= kMostLateMessages) {
    const bool is_late = Clock::now() >= deadline;
    watch(is_late ? milliseconds(0) : std::chrono::ceil<milliseconds>(deadline - Clock::now()));
    Received received = receiveMessage(child->socket(), false);
    if (received.state == Received::State::kNothingYet) {
      if (is_late) {
        break;
      }
      continue;
    }
    if (received.state == Received::State::kClosed) {
      return bury(WorkerDeath::Kind::kCrash, kGrace, "");
    }
    if (received.state == Received::State::kGarbage) {
      return buryForGarbage();
    }
    if (received.message.type != MessageType::kProgress) {
      return std::move(received.message);
    }
    last_progress = std::move(received.message.text);
    deadline = std::min(end, Clock::now() + budgetOf(phaseOf(last_progress), limits));
    late_messages += is_late ? 1 : 0;
  }
  return bury(WorkerDeath::Kind::kTimeout, milliseconds(0), "");
}

// Until the worker says something, or for `most`.
void Worker::Impl::watch(milliseconds most) {
  std::array<pollfd, 2> watched = {pollfd{child->socket(), POLLIN, 0},
                                   pollfd{stderr_open ? child->stderrPipe() : -1, POLLIN, 0}};
  ::poll(watched.data(), watched.size(), static_cast<int>(std::min(most, kLongestPoll).count()));
  if (watched[1].revents != 0) {
    stderr_open = child->drainStderr();
  }
}

WorkerDeath Worker::Impl::bury(WorkerDeath::Kind kind, milliseconds grace, const std::string& note) {
  const ChildEnd end = child->end(grace);
  WorkerDeath death = deathFrom(kind, end, last_progress, child->stderrTail(), note);
  child.reset();
  return death;
}

Worker::Worker(const DeviceEntry& entry, WorkerOptions options)
    : impl_(std::make_unique<Impl>(entry, std::move(options))) {}
Worker::~Worker() = default;
Worker::Worker(Worker&&) noexcept = default;
Worker& Worker::operator=(Worker&&) noexcept = default;

Expected<DeviceInfo> Worker::info() {
  if (!impl_->device) {
    if (const Expected<void> started = impl_->ensureStarted(); !started) {
      return tl::make_unexpected(started.error());
    }
  }
  return *impl_->device;
}

JobOutcome Worker::run(const Job& job, const JobLimits& limits) {
  return impl_->run(job, limits);
}

void Worker::rest() {
  impl_->child.reset();
}

}  // namespace ssrkit
