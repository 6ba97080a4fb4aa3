// `ssrkit devices`: each device with its identity and traits, and where it is absent, why.
#pragma once

#include <string>
#include <vector>

#include "base/error.h"

namespace ssrkit {

struct DevicesOptions {
  std::vector<std::string> devices;  // none: every device of the registry
  bool json = false;
};

// Probes the devices at once, each in its worker. 0, or 3 when one that the options name is absent: without
// names this is a list, and no machine has every device.
[[nodiscard]] Expected<int> devicesCommand(const DevicesOptions& options);

}  // namespace ssrkit
