// The goldens that a run would make, and what each of them changes.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "check/expectation.h"
#include "check/golden.h"
#include "command/kit_paths.h"
#include "command/suite.h"

namespace ssrkit {

struct Blessing {
  std::string who;
  std::string when;
  std::string why;
};

// One golden for each buffer that an expectation of the test holds against one, and each answer that it asks
// for. Fails on images over 160 x 90 texels: goldens stay small.
[[nodiscard]] Expected<std::vector<Golden>> blessCandidates(const TestFile& test, const SceneRun& run,
                                                            const std::map<std::string, DeviceInfo>& devices,
                                                            const Blessing& blessing, const KitPaths& paths);

// "m1 160x90 hiz composite (llvmpipe-1f0c52a9): 12 of 14400 texels change, by at most 0.25, first at (3, 4):
// 0.5 0.5 0.5, was 0.25 0.5 0.5", or that it is new, or the same as before.
[[nodiscard]] std::string changeText(const Golden& golden, std::span<const Golden> before);

}  // namespace ssrkit
