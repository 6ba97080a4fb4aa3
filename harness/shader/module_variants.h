// Modules that compute the same in another way: what no right driver may answer otherwise.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace ssrkit {

// The name of the member that withDeadCode adds to the uniform block. Whoever fills the block gives it -0.0.
inline constexpr const char* kDeadCodeZero = "dead_code_zero";

// The members of the uniform block in the opposite order, at the offsets that std140 gives them there. A
// module without a block stays as it is.
[[nodiscard]] std::vector<std::uint32_t> withUniformsReversed(std::span<const std::uint32_t> spirv);

// To the result of every sum, difference, product and quotient of floats the block's member kDeadCodeZero is
// added, and the entry point begins with a branch that is taken only if that member were above 1: into a
// discard, or a return in a vertex shader. x + -0.0 is x for every x, and no compiler knows the value. A
// module without a block stays as it is.
[[nodiscard]] std::vector<std::uint32_t> withDeadCode(std::span<const std::uint32_t> spirv);

}  // namespace ssrkit
