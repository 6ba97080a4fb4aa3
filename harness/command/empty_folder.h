#pragma once

#include <string>
#include <utility>

#include "base/error.h"

namespace ssrkit {

// A folder of the system's temporary ones, empty at first, that goes with its handle.
class EmptyFolder {
 public:
  [[nodiscard]] static Expected<EmptyFolder> create();
  ~EmptyFolder();
  EmptyFolder(EmptyFolder&& other) noexcept : path_(std::exchange(other.path_, {})) {}
  EmptyFolder& operator=(EmptyFolder&&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  explicit EmptyFolder(std::string path) : path_(std::move(path)) {}
  std::string path_;
};

}  // namespace ssrkit
