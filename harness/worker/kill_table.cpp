#include "worker/kill_table.h"

#include <array>
#include <atomic>
#include <csignal>

#include "worker/supervisor.h"

namespace ssrkit {

namespace {

// Far more than the devices there are. A worker that finds no place still ends when its socket closes.
constexpr std::size_t kMaxWorkers = 256;
std::array<std::atomic<pid_t>, kMaxWorkers> groups = {};
static_assert(std::atomic<pid_t>::is_always_lock_free, "a signal handler reads it");

void replaceOnce(pid_t from, pid_t to) {
  for (std::atomic<pid_t>& group : groups) {
    pid_t expected = from;
    if (group.compare_exchange_strong(expected, to)) {
      return;
    }
  }
}

}  // namespace

void rememberWorker(pid_t group) {
  replaceOnce(0, group);
}
void forgetWorker(pid_t group) {
  replaceOnce(group, 0);
}

void killAllWorkers() noexcept {
  for (const std::atomic<pid_t>& slot : groups) {
    const pid_t group = slot.load();
    if (group > 0) {
      ::kill(-group, SIGKILL);
    }
  }
}

}  // namespace ssrkit
