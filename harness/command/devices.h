// `ssrkit devices`: each device with its identity and traits, and where it is absent, why.
#pragma once

#include "base/error.h"

namespace ssrkit {

// 0 when every device is there, 3 when one is absent.
[[nodiscard]] Expected<int> devicesCommand(bool json);

}  // namespace ssrkit
