#pragma once

#include <functional>
#include <string>

namespace ssrkit {

// Told what is about to begin ("compile trace_hiz", "draw gbuffer"), so that a crash can be laid at its door.
using Progress = std::function<void(const std::string&)>;

}  // namespace ssrkit
