// Records made by hand.
#pragma once

#include <string>
#include <vector>

#include "conform/cell_record.h"
#include "conform/manifest.h"

namespace ssrkit {

inline CheckResult madeCheck(const std::string& id, Outcome outcome, const std::string& device = "gl-a") {
  return {.id = id,
          .scene = "m1",
          .device = device,
          .stage = "hiz",
          .size = {64, 36},
          .outcome = outcome,
          .metric = "different_rays",
          .value = outcome == Outcome::kPass ? 0.0 : 3.0,
          .max = 0.0,
          .unit = "rays"};
}

inline CellRecord madeRecord(const std::string& id, Outcome outcome) {
  const std::string test = id.substr(0, id.find('/'));
  return {.id = id,
          .inputs = "0123",
          .time_s = 0.5,
          .checks = {madeCheck(test + ".rays", outcome, id.substr(id.rfind('/') + 1))}};
}

// Four cells, the second and the third of which are shard 2's.
inline Manifest madeManifest(Shard shard) {
  return {.kit_version = "1.0",
          .started = "2026-01-31T12:00:00Z",
          .command = {"./ssrkit", "conform"},
          .shard = shard,
          .cells = {"t/m1/64x36/gl-a", "t/m2/64x36/gl-a", "t/m3/64x36/gl-a", "t/m4/64x36/gl-a"},
          .shard_of_cell = {1, 2, 2, 1},
          .devices = {{.identity = {.id = "gl-a",
                                    .api = "GL",
                                    .driver = "d",
                                    .version = "v",
                                    .cpu = "c",
                                    .cpu_features = {"avx2"}},
                       .traits = {.loop_cap = 65535, .device_timer_usable = true, .shader_input = "SPIR-V"}}},
          .absent = {{"vk-b", "it is not there"}}};
}

}  // namespace ssrkit
