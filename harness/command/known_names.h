#pragma once

#include "check/read_expectations.h"
#include "command/kit_paths.h"

namespace ssrkit {

// Everything that an expectation file or a claim may name: built-in scenes, devices, stages, frames,
// techniques.
[[nodiscard]] KnownNames knownNames(const KitPaths& paths);

}  // namespace ssrkit
