#include "command/empty_folder.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "base/spawn.h"
#include "base/system_error.h"

namespace ssrkit {

namespace {

// Twice: what was killed with this process may take a moment to stop writing.
constexpr const char* kRemove =
    "trap '' HUP INT TERM; read -r nothing; rm -rf -- \"$1\" || { sleep 1; rm -rf -- \"$1\"; }";

tl::unexpected<Error> noFolder(const std::string& name, int code) {
  return setupError("make an empty folder", errnoInWords(code), name,
                    "set TMPDIR to a folder that can be written to");
}

}  // namespace

Expected<EmptyFolder> EmptyFolder::create() {
  std::error_code ignored;
  std::string name = (std::filesystem::temp_directory_path(ignored) / "ssrkit-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) {
    return noFolder(name, errno);
  }
  EmptyFolder folder(name);
  if (const int error = folder.startRemover(); error != 0) {
    return noFolder(name, error);
  }
  return folder;
}

// 0 or an errno.
int EmptyFolder::startRemover() {
  std::array<int, 2> ends = {-1, -1};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
    return errno;
  }
  const OwnedFd reading(ends[0]);
  lifeline_ = OwnedFd(ends[1]);
  SpawnPlan plan;
  posix_spawn_file_actions_adddup2(plan.actions(), reading.get(), STDIN_FILENO);
  posix_spawn_file_actions_addopen(plan.actions(), STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(plan.actions(), STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addclosefrom_np(plan.actions(), STDERR_FILENO + 1);
  std::vector<std::string> words = {"/bin/sh", "-c", kRemove, "ssrkit", path_};
  std::vector<std::string> variables = mergedEnvironment({});
  // In a group of its own: Ctrl-C is not for it, and it is not killed with the other children.
  const int error = plan.setGroupAndSignals();
  return error != 0 ? error
                    : posix_spawn(&remover_, "/bin/sh", plan.actions(), plan.attributes(),
                                  pointersTo(words).data(), pointersTo(variables).data());
}

EmptyFolder::~EmptyFolder() {
  std::error_code ignored;
  if (!path_.empty()) {
    std::filesystem::remove_all(path_, ignored);
  }
  lifeline_.reset();
  while (remover_ > 0 && ::waitpid(remover_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

}  // namespace ssrkit
