#include "base/process_groups.h"

#include <array>
#include <atomic>
#include <csignal>

namespace ssrkit {

namespace {

// Far more than there are at once. A worker that finds no place still ends when its socket closes.
constexpr std::size_t kMaxGroups = 256;
std::array<std::atomic<pid_t>, kMaxGroups> groups = {};
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

void rememberGroup(pid_t group) {
  replaceOnce(0, group);
}
void forgetGroup(pid_t group) {
  replaceOnce(group, 0);
}

void killAllGroups() noexcept {
  for (const std::atomic<pid_t>& slot : groups) {
    const pid_t group = slot.load();
    if (group > 0) {
      ::kill(-group, SIGKILL);
    }
  }
}

}  // namespace ssrkit
