// A child process with a socket to it, whose stderr is drained and which never outlives its handle.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/owned_fd.h"

namespace ssrkit {

struct ChildCommand {
  std::filesystem::path executable;
  std::vector<std::string> arguments;                            // argv[1] onwards
  std::vector<std::pair<std::string, std::string>> environment;  // set over this process's own
};

// How a process ended.
struct ChildEnd {
  bool was_killed = false;  // by us, after the grace
  int signal = 0;           // 0: it exited, or somebody else took its status (SIGCHLD ignored by our parent)
  int exit_code = -1;       // -1: not known
};

// Leads a process group of its own; stdin and stdout are /dev/null, descriptor 3 is the other end of
// `socket`, and no other descriptor of ours is open in it.
class ChildProcess {
 public:
  [[nodiscard]] static Expected<ChildProcess> start(const ChildCommand& command);

  ~ChildProcess();
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&&) = delete;

  [[nodiscard]] int socket() const { return socket_.get(); }
  [[nodiscard]] int stderrPipe() const { return stderr_pipe_.get(); }

  // Reads what the child has written to stderr, without waiting and at most 1 MiB, so that one that never
  // stops cannot hold the caller. The last 64 KiB are kept. False once the child has closed it.
  bool drainStderr();
  [[nodiscard]] const std::string& stderrTail() const { return stderr_tail_; }
  void clearStderrTail() { stderr_tail_.clear(); }

  // What it holds of the machine's memory; 0 where that cannot be read.
  [[nodiscard]] std::int64_t residentBytes() const;

  // Closes the socket, waits up to `grace` for the child to end by itself, then kills its group and collects
  // it.
  ChildEnd end(std::chrono::milliseconds grace);

 private:
  ChildProcess() = default;
  bool waitForEnd(std::chrono::milliseconds grace);

  pid_t pid_ = 0;
  OwnedFd socket_;
  OwnedFd stderr_pipe_;
  std::string stderr_tail_;
};

}  // namespace ssrkit
