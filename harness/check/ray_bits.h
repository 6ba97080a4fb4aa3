// Equality to the last bit: 0 and -0 differ, and a NaN is equal to itself.
#pragma once

#include <string>
#include <vector>

#include "image/ray_record.h"

namespace ssrkit {

[[nodiscard]] bool sameBits(float a, float b);

// The names of the record's fields whose bits differ ("texel", "px", "t_m", "class", "lookups", "steps"), but
// for those in `ignore`.
[[nodiscard]] std::vector<std::string> differingFields(const RayHit& a, const RayHit& b,
                                                       const std::vector<std::string>& ignore = {});

}  // namespace ssrkit
