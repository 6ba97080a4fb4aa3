#include "command/child_program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <optional>
#include <thread>
#include <utility>

#include "base/process_groups.h"
#include "base/spawn.h"
#include "base/system_error.h"

namespace ssrkit {

namespace {

// A child that has not been collected yet. What becomes of it, nothing of its group is left.
class RunningChild {
 public:
  explicit RunningChild(pid_t pid) : pid_(pid) { rememberGroup(pid_); }
  ~RunningChild() { static_cast<void>(collect()); }
  RunningChild(const RunningChild&) = delete;
  RunningChild& operator=(const RunningChild&) = delete;

  // Until it has ended, or for ever; false when `end` came first.
  bool waitForEnd(std::optional<std::chrono::steady_clock::time_point> end,
                  const std::function<void(pid_t)>& look) const {
    constexpr std::chrono::milliseconds kPause{5};
    const int how = WEXITED | WNOWAIT | (end || look ? WNOHANG : 0);
    while (true) {
      siginfo_t info = {};
      const int result = ::waitid(P_PID, static_cast<id_t>(pid_), &info, how);
      if ((result == 0 && info.si_pid == pid_) || (result < 0 && errno != EINTR)) {
        return true;
      }
      if (end && std::chrono::steady_clock::now() >= *end) {
        return false;
      }
      if (result == 0 && look) {
        look(pid_);
      }
      std::this_thread::sleep_for(kPause);
    }
  }

  // Kills what is left of the group. The status of waitpid, or an errno's negative.
  int collect() {
    if (pid_ == 0) {
      return 0;
    }
    ::kill(-pid_, SIGKILL);
    forgetGroup(pid_);
    const pid_t pid = std::exchange(pid_, 0);
    int status = 0;
    while (::waitpid(pid, &status, 0) < 0) {
      if (errno != EINTR) {
        return -errno;
      }
    }
    return status;
  }

 private:
  pid_t pid_;
};

Expected<pid_t> startChild(const ChildProgram& program) {
  SpawnPlan plan;
  if (!program.folder.empty()) {
    posix_spawn_file_actions_addchdir_np(plan.actions(), program.folder.c_str());
  }
  posix_spawn_file_actions_addopen(plan.actions(), STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  if (!program.output.empty()) {
    posix_spawn_file_actions_addopen(plan.actions(), STDOUT_FILENO, program.output.c_str(),
                                     O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_adddup2(plan.actions(), STDOUT_FILENO, STDERR_FILENO);
  }
  std::vector<std::string> arguments = program.arguments;
  std::vector<std::string> variables = mergedEnvironment(program.environment);
  pid_t child = 0;
  int error = plan.setGroupAndSignals();
  error = error != 0 ? error
                     : posix_spawnp(&child, arguments.front().c_str(), plan.actions(), plan.attributes(),
                                    pointersTo(arguments).data(), pointersTo(variables).data());
  if (error != 0) {
    return setupError(fmt::format("run '{}'", arguments.front()), errnoInWords(error), {}, program.remedy);
  }
  return child;
}

}  // namespace

Expected<int> runChild(const ChildProgram& program, const std::function<void(pid_t)>& look) {
  const auto pid = startChild(program);
  if (!pid) {
    return tl::make_unexpected(pid.error());
  }
  RunningChild child(*pid);
  child.waitForEnd(program.limit == kNoLimit
                       ? std::nullopt
                       : std::optional(std::chrono::steady_clock::now() + program.limit),
                   look);
  const int status = child.collect();
  if (status < 0) {
    return setupError(fmt::format("run '{}'", program.arguments.front()),
                      fmt::format("how it ended cannot be told: {}", errnoInWords(-status)));
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace ssrkit
