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

// Far from what any tracer needs, and near enough to the 65,535 after which Mesa's software drivers leave a
// shader's loops.
inline constexpr std::uint32_t kCountedLoopLimit = 60000;

// A fragment shader that counts the iterations of all its loops, those of one fragment. When they were more
// than kCountedLoopLimit it writes at its end what differs from its answer in every component, in every
// format: floats below 0.5 become 1 and others 0, integers their complement. Without loops it stays as it is;
// so do fragments that it discards.
[[nodiscard]] std::vector<std::uint32_t> withCountedLoops(std::span<const std::uint32_t> spirv);

}  // namespace ssrkit
