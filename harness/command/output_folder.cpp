#include "command/output_folder.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

namespace ssrkit {

Expected<void> prepareFolder(const std::filesystem::path& folder) {
  const std::string attempted = "write to the output folder";
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    return setupError(attempted, error.message(), folder.string(), "choose another one with --out");
  }
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    return setupError(attempted, std::strerror(errno), folder.string(), "choose another one with --out");
  }
  return {};
}

}  // namespace ssrkit
