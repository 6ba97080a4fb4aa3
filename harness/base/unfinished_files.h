// The temporary files of writes under way, in a table that a signal handler may read.
#pragma once

#include <cstddef>
#include <filesystem>

namespace ssrkit {

// Holds one temporary file: listed from construction, and deleted at destruction unless `release` was called.
class UnfinishedFile {
 public:
  explicit UnfinishedFile(const std::filesystem::path& temporary);
  ~UnfinishedFile();
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

  // The file has its final name now: nothing is left to delete.
  void release() noexcept;

 private:
  std::size_t slot_;
};

}  // namespace ssrkit
