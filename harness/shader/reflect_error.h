// Thrown inside the reflection only, and caught in reflectSpirv: SPIRV-Cross reports by exceptions as well.
#pragma once

#include <stdexcept>

namespace ssrkit {

struct UnsupportedInterface : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace ssrkit
