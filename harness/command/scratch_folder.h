// A folder for files that nobody needs afterwards.
#pragma once

#include <filesystem>
#include <memory>

#include "base/error.h"

namespace ssrkit {

class ScratchFolder {
 public:
  // Under the system's folder for temporary files; removed with everything in it at the end.
  [[nodiscard]] static Expected<std::unique_ptr<ScratchFolder>> create();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  explicit ScratchFolder(std::filesystem::path path) : path_(std::move(path)) {}

  std::filesystem::path path_;
};

}  // namespace ssrkit
