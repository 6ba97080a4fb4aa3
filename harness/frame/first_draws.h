// A device that says when a driver compiles: drivers of Mesa do so inside a program's first draw.
#pragma once

#include <set>

#include "device/forwarding_device.h"
#include "frame/progress.h"

namespace ssrkit {

// Draws each program once with an empty scissor before its first draw, under the progress "build PASS": the
// driver compiles for the very state that the pass is drawn in, and no fragment runs. So the two can be told
// apart, and limited apart. The time of that draw is part of the first one's.
class FirstDraws final : public ForwardingDevice {
 public:
  using ForwardingDevice::ForwardingDevice;

  // Forgets which programs have been drawn. `progress` must outlive the job.
  void startJob(const Progress& progress);

  [[nodiscard]] Expected<PassTime> draw(const PassDesc& pass) override;

 private:
  const Progress* progress_ = nullptr;
  std::set<const DeviceProgram*> drawn_;
};

}  // namespace ssrkit
