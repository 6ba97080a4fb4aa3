#include "check/ray_bits.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>

namespace ssrkit {

bool sameBits(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

std::vector<std::string> differingFields(const RayHit& a, const RayHit& b,
                                         const std::vector<std::string>& ignore) {
  const std::pair<const char*, bool> fields[] = {
      {"texel", a.texel_x != b.texel_x || a.texel_y != b.texel_y},
      {"px", !sameBits(a.px_x, b.px_x) || !sameBits(a.px_y, b.px_y)},
      {"t_m", !sameBits(a.t_m, b.t_m)},
      {"class", a.ray_class != b.ray_class},
      {"lookups", a.lookups != b.lookups},
      {"steps", a.steps != b.steps},
  };
  std::vector<std::string> names;
  for (const auto& [field, differs] : fields) {
    if (differs && std::ranges::find(ignore, field) == ignore.end()) {
      names.emplace_back(field);
    }
  }
  return names;
}

}  // namespace ssrkit
