#pragma once

#include <cstddef>
#include <span>

namespace ssrkit {

// Writes all the bytes to the descriptor, however many calls that takes. 0, or the errno of the call that
// failed: ENOSPC where one wrote nothing.
[[nodiscard]] int writeAll(int fd, std::span<const std::byte> bytes);

}  // namespace ssrkit
