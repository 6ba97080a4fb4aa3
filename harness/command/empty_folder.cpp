#include "command/empty_folder.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace ssrkit {

Expected<EmptyFolder> EmptyFolder::create() {
  std::error_code ignored;
  std::string name = (std::filesystem::temp_directory_path(ignored) / "ssrkit-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) {
    return setupError("make an empty folder", std::strerror(errno), name,
                      "set TMPDIR to a folder that can be written to");
  }
  return EmptyFolder(name);
}

EmptyFolder::~EmptyFolder() {
  std::error_code ignored;
  if (!path_.empty()) {
    std::filesystem::remove_all(path_, ignored);
  }
}

}  // namespace ssrkit
