#include "worker/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <string>

#include "base/process_groups.h"
#include "worker/spawn.h"

namespace ssrkit {

namespace {

constexpr std::size_t kStderrTailBytes = std::size_t{64} << 10;

tl::unexpected<Error> cannotStart(const ChildCommand& command, const std::string& problem) {
  return setupError("start a worker process", command.executable.string() + ": " + problem);
}

ChildEnd collect(pid_t pid) {
  int status = 0;
  pid_t result = 0;
  do {
    result = ::waitpid(pid, &status, 0);
  } while (result < 0 && errno == EINTR);
  ChildEnd end;
  if (result == pid && WIFSIGNALED(status)) {
    end.signal = WTERMSIG(status);
  } else if (result == pid && WIFEXITED(status)) {
    end.exit_code = WEXITSTATUS(status);
  }
  return end;
}

}  // namespace

Expected<ChildProcess> ChildProcess::start(const ChildCommand& command) {
  std::array<int, 2> sockets = {-1, -1};
  if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, sockets.data()) != 0) {
    return cannotStart(command, std::string("no socket: ") + std::strerror(errno));
  }
  ChildProcess child;
  child.socket_ = OwnedFd(sockets[0]);
  const OwnedFd child_socket(sockets[1]);

  std::array<int, 2> pipe = {-1, -1};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) {
    return cannotStart(command, std::string("no pipe: ") + std::strerror(errno));
  }
  child.stderr_pipe_ = OwnedFd(pipe[0]);
  const OwnedFd child_stderr(pipe[1]);
  ::fcntl(child.stderr_pipe_.get(), F_SETFL, O_NONBLOCK);  // our end only: the child's may block

  const Expected<pid_t> pid = spawn(command, child_socket.get(), child_stderr.get());
  if (!pid) {
    return tl::make_unexpected(pid.error());
  }
  child.pid_ = *pid;
  rememberGroup(child.pid_);
  return child;
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : pid_(std::exchange(other.pid_, 0)),
      socket_(std::move(other.socket_)),
      stderr_pipe_(std::move(other.stderr_pipe_)),
      stderr_tail_(std::move(other.stderr_tail_)) {}

ChildProcess::~ChildProcess() {
  if (pid_ > 0) {
    end(std::chrono::milliseconds(1000));
  }
}

bool ChildProcess::drainStderr() {
  std::array<char, 65536> buffer;
  for (int round = 0; round < 16; ++round) {
    const ssize_t count = ::read(stderr_pipe_.get(), buffer.data(), buffer.size());
    if (count <= 0) {
      return count < 0;
    }
    stderr_tail_.append(buffer.data(), static_cast<std::size_t>(count));
    if (stderr_tail_.size() > kStderrTailBytes) {
      stderr_tail_.erase(0, stderr_tail_.size() - kStderrTailBytes);
    }
  }
  return true;
}

// Waits for the child to become a zombie, which leaves its number taken.
bool ChildProcess::waitForEnd(std::chrono::milliseconds grace) {
  const auto deadline = std::chrono::steady_clock::now() + grace;
  while (true) {
    siginfo_t info = {};
    const int result = ::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT);
    if ((result == 0 && info.si_pid == pid_) || (result < 0 && errno == ECHILD)) {
      return true;
    }
    if (std::chrono::steady_clock::now() >= deadline) {
      return false;
    }
    drainStderr();  // a child that cannot write cannot end
    ::poll(nullptr, 0, 1);
  }
}

std::int64_t ChildProcess::residentBytes() const {
  std::ifstream file("/proc/" + std::to_string(pid_) + "/statm");
  std::int64_t all_pages = 0;
  std::int64_t resident_pages = 0;
  file >> all_pages >> resident_pages;
  return file ? resident_pages * ::sysconf(_SC_PAGESIZE) : 0;
}

ChildEnd ChildProcess::end(std::chrono::milliseconds grace) {
  socket_.reset();
  const bool ended = waitForEnd(grace);
  ::kill(-pid_, SIGKILL);  // also when it has ended: what it may have started shares its group
  forgetGroup(pid_);
  ChildEnd how = collect(std::exchange(pid_, 0));
  drainStderr();
  how.was_killed = !ended;
  return how;
}

}  // namespace ssrkit
