#include "command/run_step_note.h"

#include <fmt/format.h>

#include <algorithm>

namespace ssrkit {

std::optional<std::string> shortStepNote(const TraceResult& trace) {
  if (trace.parameters.step_m <= 0.0) {
    return std::nullopt;
  }
  // The naive march takes no step onto the ray's end.
  const auto longest = std::ranges::count_if(trace.record.rays, [](const RayHit& ray) {
    return ray.ray_class != RayClass::kBudget && ray.steps + 1 >= static_cast<std::uint32_t>(kMaxStepCount);
  });
  if (longest == 0) {
    return std::nullopt;
  }
  return fmt::format(
      "{} rays of '{}' took {} steps, the most that there are; where step_m = {} would have needed more, "
      "their "
      "steps were longer",
      longest, trace.stage, kMaxStepCount, trace.parameters.step_m);
}

}  // namespace ssrkit
