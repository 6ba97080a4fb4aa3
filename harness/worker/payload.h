// The body of a message: one piece of anonymous shared memory, a header of small fields and then the images
// and records one after the other. It is written and read with system calls rather than mapped: each byte is
// copied once on each side all the same, and a peer that shortens the memory cannot make the reader fault.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/owned_fd.h"

namespace ssrkit {

struct Payload {
  OwnedFd memory;
  std::uint64_t header_bytes = 0;
  std::uint64_t bulk_bytes = 0;
};

struct BulkPart {
  std::span<const std::byte> bytes;
  std::function<void()> release;  // called once the bytes are copied; empty: nothing to do
};

// Copies the header and the parts to new shared memory. Fails when memory runs out.
[[nodiscard]] Expected<Payload> makePayload(std::span<const std::byte> header,
                                            std::span<const BulkPart> bulk);

// Whether the memory is as large as the payload says: asked once of everything that a peer sends.
[[nodiscard]] bool hasDeclaredSize(const Payload& payload);

// Reads from byte `offset` of the whole payload. False when the memory ends before.
[[nodiscard]] bool readPayload(const Payload& payload, std::uint64_t offset, std::span<std::byte> bytes);

// Gives the memory of these bytes back: they must not be read again.
void releasePayload(const Payload& payload, std::uint64_t offset, std::uint64_t byte_count);

}  // namespace ssrkit
