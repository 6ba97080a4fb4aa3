#include "frame/pass_times.h"

#include <algorithm>
#include <utility>

#include "device/pass_clock.h"

namespace ssrkit {

void PassTimes::add(const std::string& pass, const PassTime& time) {
  const auto drawn = std::ranges::find(round_, pass, &Drawn::pass);
  if (drawn == round_.end()) {
    round_.push_back({pass, time});
    return;
  }
  drawn->time += time;
}

void PassTimes::endRound() {
  for (const Drawn& drawn : std::exchange(round_, {})) {
    const auto report = std::ranges::find(reports_, drawn.pass, &PassReport::pass);
    if (report == reports_.end()) {
      reports_.push_back({.pass = drawn.pass, .cold = drawn.time, .steady = {}});
    } else {
      report->steady.push_back(drawn.time);
    }
  }
}

}  // namespace ssrkit
