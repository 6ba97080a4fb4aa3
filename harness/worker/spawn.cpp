#include "worker/spawn.h"

#include <fcntl.h>

#include <cerrno>
#include <cstring>

#include "base/spawn.h"

namespace ssrkit {

namespace {

constexpr int kSocketInChild = 3;

// `socket` and `stderr_pipe` are above the numbers they are moved to. Returns 0 or an errno.
int setDescriptors(posix_spawn_file_actions_t* actions, int socket, int stderr_pipe) {
  int error = ::posix_spawn_file_actions_addopen(actions, 0, "/dev/null", O_RDONLY, 0);
  error = error != 0 ? error : ::posix_spawn_file_actions_addopen(actions, 1, "/dev/null", O_WRONLY, 0);
  error = error != 0 ? error : ::posix_spawn_file_actions_adddup2(actions, stderr_pipe, 2);
  error = error != 0 ? error : ::posix_spawn_file_actions_adddup2(actions, socket, kSocketInChild);
  // Libraries of this process may have opened files without close-on-exec.
  return error != 0 ? error : ::posix_spawn_file_actions_addclosefrom_np(actions, kSocketInChild + 1);
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
  if (const int error = setDescriptors(plan.actions(), high_socket.get(), high_stderr.get()); error != 0) {
    return failed(error);
  }
  if (const int error = plan.setGroupAndSignals(); error != 0) {
    return failed(error);
  }
  std::vector<std::string> arguments = {"ssrkit"};
  arguments.insert(arguments.end(), command.arguments.begin(), command.arguments.end());
  std::vector<std::string> environment = mergedEnvironment(command.environment);
  pid_t pid = 0;
  const int error = ::posix_spawn(&pid, command.executable.c_str(), plan.actions(), plan.attributes(),
                                  pointersTo(arguments).data(), pointersTo(environment).data());
  if (error != 0) {
    return failed(error);
  }
  return pid;
}

}  // namespace ssrkit
