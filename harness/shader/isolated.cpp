#include "shader/isolated.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <new>
#include <span>

#include "base/owned_fd.h"
#include "base/write_all.h"

#ifdef SSRKIT_COVERAGE
extern "C" {
#include <gcov.h>
}
#endif

namespace ssrkit {

namespace {

constexpr int kExitDone = 0;
constexpr int kExitOutOfMemory = 10;
constexpr int kExitFailed = 11;

void limitMemory([[maybe_unused]] std::size_t more_bytes) {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // they reserve terabytes of addresses
  std::ifstream statm("/proc/self/statm");
  std::uint64_t pages = 0;
  if (statm >> pages) {
    const rlim_t bytes = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + more_bytes;
    const rlimit limit{bytes, bytes};
    setrlimit(RLIMIT_AS, &limit);
  }
#endif
}

void prepareChild(const IsolationLimits& limits) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGSEGV, SIGABRT, SIGBUS, SIGPIPE, SIGXCPU}) {
    std::signal(number, SIG_DFL);
  }
  const auto seconds = static_cast<rlim_t>(limits.cpu_seconds);
  const rlimit cpu{seconds, seconds + 1};
  setrlimit(RLIMIT_CPU, &cpu);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  limitMemory(limits.memory_bytes);
  // What the compiler's own assertions print is no sentence for the user.
  const OwnedFd nowhere(open("/dev/null", O_WRONLY | O_CLOEXEC));
  dup2(nowhere.get(), STDERR_FILENO);
}

std::string sizePrefix(std::uint64_t size) {
  std::string prefix(sizeof size, '\0');
  std::memcpy(prefix.data(), &size, sizeof size);
  return prefix;
}

// A sibling's child may hold the pipe open, so the end of the bytes is told by their count.
bool isWhole(const std::string& received) {
  std::uint64_t size = 0;
  if (received.size() < sizeof size) {
    return false;
  }
  std::memcpy(&size, received.data(), sizeof size);
  return received.size() - sizeof size >= size;
}

[[noreturn]] void runChild(const std::function<std::string()>& work, const IsolationLimits& limits, int fd) {
  prepareChild(limits);
  int code = kExitFailed;
  try {
    const std::string bytes = work();
    const std::string sent = sizePrefix(bytes.size()) + bytes;
    code = writeAll(fd, std::as_bytes(std::span(sent))) == 0 ? kExitDone : kExitFailed;
  } catch (const std::bad_alloc&) {
    code = kExitOutOfMemory;
  } catch (...) {
    code = kExitFailed;
  }
#ifdef SSRKIT_COVERAGE
  __gcov_dump();  // a child that leaves by _exit would lose its counts
#endif
  _exit(code);
}

// The child's bytes, whole or up to its end; false when it is still there after the wall-clock limit.
bool readResult(int fd, std::string& bytes, std::chrono::seconds limit) {
  const auto deadline = std::chrono::steady_clock::now() + limit;
  std::array<char, 1 << 16> block;
  while (!isWhole(bytes)) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
    pollfd waiting{fd, POLLIN, 0};
    const int ready = poll(&waiting, 1, static_cast<int>(std::max<std::int64_t>(left.count(), 0)));
    if (ready == 0) {
      return false;
    }
    const ssize_t count = ready < 0 ? -1 : read(fd, block.data(), block.size());
    if (count == 0 || (count < 0 && errno != EINTR)) {
      return true;
    }
    bytes.append(block.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
  }
  return true;
}

IsolatedResult done(const std::string& bytes) {
  return {IsolationEnd::kDone, bytes.substr(sizeof(std::uint64_t)), {}};
}

IsolatedResult judge(int status, const std::string& bytes) {
  if (WIFEXITED(status)) {
    const int code = WEXITSTATUS(status);
    if (code == kExitDone && isWhole(bytes)) {
      return done(bytes);
    }
    return {
        code == kExitOutOfMemory ? IsolationEnd::kOutOfMemory : IsolationEnd::kCrashed, {}, "an exception"};
  }
  const int number = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  const bool over_time = number == SIGXCPU || number == SIGKILL;
  return {over_time ? IsolationEnd::kOverTime : IsolationEnd::kCrashed, {}, strsignal(number)};
}

}  // namespace

IsolatedResult runIsolated(const std::function<std::string()>& work, const IsolationLimits& limits) {
  std::array<int, 2> ends{-1, -1};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    return {IsolationEnd::kNotStarted, {}, std::strerror(errno)};
  }
  const OwnedFd reading(ends[0]);
  OwnedFd writing(ends[1]);
  const pid_t child = fork();
  if (child < 0) {
    return {IsolationEnd::kNotStarted, {}, std::strerror(errno)};
  }
  if (child == 0) {
    runChild(work, limits, writing.get());
  }
  writing.reset();
  // CPU time is the limit; the clock on the wall is only there for a child that waits for something.
  constexpr int kWallPerCpuSecond = 6;
  std::string bytes;
  if (!readResult(reading.get(), bytes, std::chrono::seconds(limits.cpu_seconds * kWallPerCpuSecond))) {
    kill(child, SIGKILL);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) {
      // How it ended cannot be told (SIGCHLD is ignored): a whole result says that it did its work.
      return isWhole(bytes) ? done(bytes) : IsolatedResult{IsolationEnd::kCrashed, {}, std::strerror(errno)};
    }
  }
  return judge(status, bytes);
}

}  // namespace ssrkit
