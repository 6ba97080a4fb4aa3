// Frames at equal steps of time. The last one is what is asked for; those before it are its history.
#pragma once

#include <algorithm>
#include <optional>

namespace ssrkit {

struct Sequence {
  std::optional<double> time_s;  // of the last frame; absent: the first frame is at 0 s
  int frame_count = 1;
  double time_step_s = 1.0 / 30.0;

  bool operator==(const Sequence&) const = default;
};

[[nodiscard]] inline double timeOf(const Sequence& sequence, int frame) {
  const double last_s = sequence.time_s.value_or((sequence.frame_count - 1) * sequence.time_step_s);
  return last_s - (sequence.frame_count - 1 - frame) * sequence.time_step_s;
}

// The first frame has none before it: nothing moves in it.
[[nodiscard]] inline double previousTimeOf(const Sequence& sequence, int frame) {
  return timeOf(sequence, std::max(frame - 1, 0));
}

}  // namespace ssrkit
