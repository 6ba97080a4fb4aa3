// Which files a shader may name: those under its roots, and nothing that a link or `..` leads to elsewhere.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"
#include "shader/compiler.h"

namespace ssrkit {

class VirtualRoot {
 public:
  // Fails when the root is not a folder or the entry is missing, a folder, or outside the root.
  [[nodiscard]] static Expected<VirtualRoot> open(const ShaderSource& source, const std::string& attempted);

  [[nodiscard]] const std::filesystem::path& entry() const { return entry_; }

  // The canonical path of an include. `problem` of the error is a clause that can stand after "#include: ".
  [[nodiscard]] Expected<std::filesystem::path> resolve(const std::string& name,
                                                        const std::filesystem::path& including_folder) const;

 private:
  [[nodiscard]] Expected<void> openEntry(const ShaderSource& source, const std::string& attempted);
  [[nodiscard]] bool contains(const std::filesystem::path& canonical) const;
  [[nodiscard]] std::string missingMessage(const std::string& name,
                                           const std::filesystem::path& including_folder) const;

  std::vector<std::filesystem::path> roots_;  // canonical
  std::filesystem::path include_folder_;      // empty without a shader root
  std::filesystem::path entry_;               // canonical, but for a link that the user named
};

}  // namespace ssrkit
