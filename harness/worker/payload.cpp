#include "worker/payload.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>

#include "base/write_all.h"

namespace ssrkit {

namespace {

tl::unexpected<Error> noMemory(int code) {
  return setupError("hand data from one process to another",
                    std::string("no shared memory: ") + std::strerror(code), {},
                    "free some memory, or choose a smaller size or fewer stages");
}

}  // namespace

Expected<Payload> makePayload(std::span<const std::byte> header, std::span<const BulkPart> bulk) {
  Payload payload{OwnedFd(::memfd_create("ssrkit-message", MFD_CLOEXEC)), header.size(), 0};
  if (!payload.memory) {
    return noMemory(errno);
  }
  if (const int code = writeAll(payload.memory.get(), header); code != 0) {
    return noMemory(code);
  }
  for (const BulkPart& part : bulk) {
    if (const int code = writeAll(payload.memory.get(), part.bytes); code != 0) {
      return noMemory(code);
    }
    payload.bulk_bytes += part.bytes.size();
    if (part.release) {
      part.release();
    }
  }
  return payload;
}

bool hasDeclaredSize(const Payload& payload) {
  struct stat status = {};
  if (::fstat(payload.memory.get(), &status) != 0 || !S_ISREG(status.st_mode) || status.st_size < 0) {
    return false;
  }
  const auto size = static_cast<std::uint64_t>(status.st_size);
  return payload.header_bytes <= size && payload.bulk_bytes == size - payload.header_bytes;
}

bool readPayload(const Payload& payload, std::uint64_t offset, std::span<std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t count =
        ::pread(payload.memory.get(), bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (count < 0 && errno == EINTR) {
      continue;
    }
    if (count <= 0) {
      return false;
    }
    bytes = bytes.subspan(static_cast<std::size_t>(count));
    offset += static_cast<std::uint64_t>(count);
  }
  return true;
}

void releasePayload(const Payload& payload, std::uint64_t offset, std::uint64_t byte_count) {
  // Only whole pages go. Where it cannot be done the memory stays until the payload goes.
  static_cast<void>(::fallocate(payload.memory.get(), FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE,
                                static_cast<off_t>(offset), static_cast<off_t>(byte_count)));
}

}  // namespace ssrkit
