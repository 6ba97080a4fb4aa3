#include "worker/spawn.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string_view>

namespace ssrkit {

namespace {

constexpr int kSocketInChild = 3;

// posix_spawn rather than fork: other threads may hold locks, and it returns exec's own error.
class SpawnPlan {
 public:
  SpawnPlan() {
    ::posix_spawn_file_actions_init(&actions_);
    ::posix_spawnattr_init(&attributes_);
  }
  ~SpawnPlan() {
    ::posix_spawnattr_destroy(&attributes_);
    ::posix_spawn_file_actions_destroy(&actions_);
  }
  SpawnPlan(const SpawnPlan&) = delete;
  SpawnPlan& operator=(const SpawnPlan&) = delete;

  // `socket` and `stderr_pipe` are above the numbers they are moved to. Returns 0 or an errno.
  int setDescriptors(int socket, int stderr_pipe) {
    int error = ::posix_spawn_file_actions_addopen(&actions_, 0, "/dev/null", O_RDONLY, 0);
    error = error != 0 ? error : ::posix_spawn_file_actions_addopen(&actions_, 1, "/dev/null", O_WRONLY, 0);
    error = error != 0 ? error : ::posix_spawn_file_actions_adddup2(&actions_, stderr_pipe, 2);
    error = error != 0 ? error : ::posix_spawn_file_actions_adddup2(&actions_, socket, kSocketInChild);
    // Libraries of this process may have opened files without close-on-exec.
    return error != 0 ? error : ::posix_spawn_file_actions_addclosefrom_np(&actions_, kSocketInChild + 1);
  }

  // A process group of its own, and no blocked or ignored signal of ours: SIGXCPU must end the child.
  int setGroupAndSignals() {
    sigset_t none;
    sigset_t all;
    ::sigemptyset(&none);
    ::sigfillset(&all);
    ::posix_spawnattr_setsigmask(&attributes_, &none);
    ::posix_spawnattr_setsigdefault(&attributes_, &all);
    ::posix_spawnattr_setpgroup(&attributes_, 0);
    return ::posix_spawnattr_setflags(&attributes_,
                                      POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }

  [[nodiscard]] const posix_spawn_file_actions_t* actions() const { return &actions_; }
  [[nodiscard]] const posix_spawnattr_t* attributes() const { return &attributes_; }

 private:
  posix_spawn_file_actions_t actions_;
  posix_spawnattr_t attributes_;
};

std::vector<std::string> mergedEnvironment(const ChildCommand& command) {
  std::vector<std::string> merged;
  for (const auto& [name, value] : command.environment) {
    merged.push_back(fmt::format("{}={}", name, value));
  }
  for (char** entry = environ; entry != nullptr && *entry != nullptr; ++entry) {
    const std::string_view text = *entry;
    const std::string_view name = text.substr(0, text.find('='));
    const bool replaced = std::any_of(command.environment.begin(), command.environment.end(),
                                      [&](const auto& pair) { return pair.first == name; });
    if (!replaced) {
      merged.emplace_back(text);
    }
  }
  return merged;
}

std::vector<char*> pointersTo(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  pointers.reserve(texts.size() + 1);
  for (std::string& text : texts) {
    pointers.push_back(text.data());
  }
  pointers.push_back(nullptr);
  return pointers;
}

// Above every number that the child's own descriptors are moved to, so that no move overwrites another's
// source.
OwnedFd movedUp(int fd) {
  return OwnedFd(::fcntl(fd, F_DUPFD_CLOEXEC, kSocketInChild + 1));
}

}  // namespace

Expected<pid_t> spawn(const ChildCommand& command, int socket, int stderr_pipe) {
  const auto failed = [&](int error) {
    return setupError("start a worker process", command.executable.string() + ": " + std::strerror(error));
  };
  const OwnedFd high_socket = movedUp(socket);
  const OwnedFd high_stderr = movedUp(stderr_pipe);
  if (!high_socket || !high_stderr) {
    return failed(errno);
  }
  SpawnPlan plan;
  if (const int error = plan.setDescriptors(high_socket.get(), high_stderr.get()); error != 0) {
    return failed(error);
  }
  if (const int error = plan.setGroupAndSignals(); error != 0) {
    return failed(error);
  }
  std::vector<std::string> arguments = {"ssrkit"};
  arguments.insert(arguments.end(), command.arguments.begin(), command.arguments.end());
  std::vector<std::string> environment = mergedEnvironment(command);
  pid_t pid = 0;
  const int error = ::posix_spawn(&pid, command.executable.c_str(), plan.actions(), plan.attributes(),
                                  pointersTo(arguments).data(), pointersTo(environment).data());
  if (error != 0) {
    return failed(error);
  }
  return pid;
}

}  // namespace ssrkit
