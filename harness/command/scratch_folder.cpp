#include "command/scratch_folder.h"

#include <cstdlib>
#include <cstring>
#include <string>

namespace ssrkit {

Expected<std::unique_ptr<ScratchFolder>> ScratchFolder::create() {
  std::error_code failed;
  const std::filesystem::path parent = std::filesystem::temp_directory_path(failed);
  std::string name = (parent / "ssrkit-XXXXXX").string();
  if (failed || mkdtemp(name.data()) == nullptr) {
    return setupError("make a folder for temporary files", failed ? failed.message() : std::strerror(errno),
                      name);
  }
  return std::unique_ptr<ScratchFolder>(new ScratchFolder(name));
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace ssrkit
