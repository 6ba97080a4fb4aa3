#pragma once

#include <sys/types.h>

#include <string>
#include <utility>

#include "base/error.h"
#include "base/owned_fd.h"

namespace ssrkit {

// A folder of the system's temporary ones, empty at first, that goes with its handle, or with this process
// when that ends before: a small process of its own (/bin/sh) waits for either and removes what is left.
class EmptyFolder {
 public:
  [[nodiscard]] static Expected<EmptyFolder> create();
  ~EmptyFolder();
  EmptyFolder(EmptyFolder&& other) noexcept
      : path_(std::exchange(other.path_, {})),
        lifeline_(std::move(other.lifeline_)),
        remover_(std::exchange(other.remover_, 0)) {}
  EmptyFolder& operator=(EmptyFolder&&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  explicit EmptyFolder(std::string path) : path_(std::move(path)) {}
  [[nodiscard]] int startRemover();

  std::string path_;
  OwnedFd lifeline_;  // the remover reads its other end: it closes with the handle, and with the process
  pid_t remover_ = 0;
};

}  // namespace ssrkit
