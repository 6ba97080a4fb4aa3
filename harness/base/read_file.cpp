#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>

#include "base/atomic_file.h"
#include "base/owned_fd.h"
#include "base/system_error.h"

namespace ssrkit {

namespace fs = std::filesystem;

namespace {

tl::unexpected<Error> readError(const fs::path& path, std::string problem, std::string remedy = {}) {
  return inputError(fmt::format("read '{}'", path.string()), std::move(problem), {}, std::move(remedy));
}

tl::unexpected<Error> openError(const fs::path& path, int code) {
  if (code == ENOENT) {
    return readError(path, "there is no such file", "check the spelling of the path");
  }
  return readError(path, errnoInWords(code));
}

// Reads to the end or just past the limit: a file may grow while it is read.
int readUpTo(int fd, std::size_t size_limit_bytes, std::string& content) {
  std::array<char, 1 << 16> block;
  while (content.size() <= size_limit_bytes) {
    const ssize_t count = read(fd, block.data(), block.size());
    if (count == 0) {
      return 0;
    }
    if (count < 0 && errno != EINTR) {
      return errno;
    }
    content.append(block.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  }
  return 0;
}

}  // namespace

Expected<std::string> readFile(const fs::path& path, std::size_t size_limit_bytes) {
  // O_NONBLOCK: opening a pipe that nobody writes to must not hang.
  const OwnedFd file(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  struct stat status {};
  if (file.get() < 0 || fstat(file.get(), &status) != 0) {
    return openError(path, errno);
  }
  if (S_ISDIR(status.st_mode)) {
    return readError(path, "it is a folder", "name a file");
  }
  if (!S_ISREG(status.st_mode)) {
    return readError(path, "it is a device or a pipe", "name a file");
  }
  std::string content;
  if (static_cast<unsigned long long>(status.st_size) <= size_limit_bytes) {
    content.reserve(static_cast<std::size_t>(status.st_size) + 1);
    if (const int code = readUpTo(file.get(), size_limit_bytes, content); code != 0) {
      return readError(path, errnoInWords(code));
    }
    if (content.size() <= size_limit_bytes) {
      return content;
    }
  }
  return readError(path, fmt::format("it is larger than the limit of {} bytes", size_limit_bytes));
}

}  // namespace ssrkit
