#pragma once

#include <set>
#include <string>

namespace ssrkit {

// The images that devices store as halves: their ulps are counted in halves.
[[nodiscard]] const std::set<std::string>& halfBuffers();

}  // namespace ssrkit
