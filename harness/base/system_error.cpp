#include "base/system_error.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>

namespace ssrkit {

namespace fs = std::filesystem;

namespace {

// The lowest part of the path that exists and is not a folder: what stands in the way of an ENOTDIR.
fs::path fileInTheWay(const fs::path& path) {
  fs::path built;
  for (const fs::path& part : path) {
    built /= part;
    std::error_code ignored;
    if (fs::exists(built, ignored) && !fs::is_directory(built, ignored)) {
      return built;
    }
  }
  return path;
}

}  // namespace

std::string errnoInWords(int code) {
  const char* const words = strerrordesc_np(code);
  const char* const symbol = strerrorname_np(code);
  if (words == nullptr || symbol == nullptr) {
    return fmt::format("system error {}", code);
  }
  return fmt::format("{} ({})", words, symbol);
}

std::string remedyForWriting(const fs::path& path, int code) {
  switch (code) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return "free some disk space or write to another disk";
    case ENOTDIR:
    case EEXIST:
      return fmt::format("'{}' is a file where a folder is needed: remove it or write to another folder",
                         fileInTheWay(path).string());
    case ENAMETOOLONG:
      return "choose a shorter name";
    case EISDIR:
      return "remove that folder or choose another name";
    case EINVAL:
      return "name an ordinary file";
    default:
      return "make the folder writable or write to another one";
  }
}

}  // namespace ssrkit
