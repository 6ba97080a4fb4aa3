#include "base/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <climits>
#include <utility>

#include "base/system_error.h"
#include "base/unfinished_files.h"
#include "base/write_all.h"

namespace ssrkit {

namespace fs = std::filesystem;

namespace {

using TemporaryWriter = std::function<Expected<void>(const fs::path&)>;

tl::unexpected<Error> writeError(const fs::path& path, int code) {
  return setupError(fmt::format("write '{}'", path.string()), errnoInWords(code), {},
                    remedyForWriting(path, code));
}

// ".STEM.PID-COUNTER.tmp.EXT": hidden from listings, and the extension still tells a writer its format.
// The stem is cut so that any name the file system takes has a temporary name it takes too. An extension that
// leaves no room for that is none that a writer knows, and is left out.
fs::path temporaryName(const fs::path& path) {
  static std::atomic<unsigned> counter{0};
  std::string suffix = fmt::format(".{}-{}.tmp", getpid(), counter.fetch_add(1));
  if (const std::string extension = path.extension().string();
      1 + suffix.size() + extension.size() <= NAME_MAX) {
    suffix += extension;
  }
  std::string stem = path.stem().string();
  stem.resize(std::min(stem.size(), NAME_MAX - 1 - suffix.size()));
  return path.parent_path() / ("." + stem + suffix);
}

// Creates the file, so that every error of the folder shows here and with its own errno.
int reserve(const fs::path& temporary) {
  const int fd = open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (fd < 0) {
    return errno;
  }
  return close(fd) == 0 ? 0 : errno;
}

int fill(const fs::path& temporary, std::string_view content) {
  const int fd = open(temporary.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
  if (fd < 0) {
    return errno;
  }
  const int write_code = writeAll(fd, std::as_bytes(std::span(content)));
  const int close_code = close(fd) == 0 ? 0 : errno;
  return write_code != 0 ? write_code : close_code;
}

// A rename would replace a device or a pipe by a file, which nobody who names one wants.
int refusal(const fs::path& target) {
  std::error_code code;
  const fs::file_status status = fs::status(target, code);
  if (!fs::exists(status) || fs::is_regular_file(status)) {
    return 0;
  }
  return fs::is_directory(status) ? EISDIR : EINVAL;
}

Expected<void> writeThroughTemporary(const fs::path& path, const fs::path& target,
                                     const TemporaryWriter& write) {
  constexpr int kNamesToTry = 100;  // another machine with the same pid may share the folder
  for (int attempt = 0; attempt < kNamesToTry; ++attempt) {
    const fs::path temporary = temporaryName(target);
    if (temporary.native().size() >= PATH_MAX) {
      return writeError(path, ENAMETOOLONG);
    }
    UnfinishedFile unfinished(temporary);
    if (const int code = reserve(temporary); code != 0) {
      unfinished.release();
      if (code == EEXIST) {
        continue;
      }
      return writeError(path, code);
    }
    if (Expected<void> written = write(temporary); !written) {
      return written;
    }
    if (rename(temporary.c_str(), target.c_str()) != 0) {
      return writeError(path, errno);
    }
    unfinished.release();
    return {};
  }
  return writeError(path, EAGAIN);
}

}  // namespace

Expected<void> writeFileAtomically(const fs::path& path, const TemporaryWriter& write) {
  std::error_code code;
  const fs::path target =
      fs::absolute(path, code);  // the working folder may change while the file is written
  if (code || !path.has_filename()) {
    return writeError(path, code ? code.value() : EISDIR);
  }
  fs::create_directories(target.parent_path(), code);
  if (code) {
    return writeError(path, code.value());
  }
  if (const int refused = refusal(target); refused != 0) {
    return writeError(path, refused);
  }
  return writeThroughTemporary(path, target, write);
}

Expected<void> writeFileAtomically(const fs::path& path, std::string_view content) {
  return writeFileAtomically(path, [&](const fs::path& temporary) -> Expected<void> {
    if (const int code = fill(temporary, content); code != 0) {
      return writeError(path, code);
    }
    return {};
  });
}

}  // namespace ssrkit
