#include "command/truth_lane.h"

#include <utility>

namespace ssrkit {

void TruthLane::add(CellRun& cell, const WantedTruths& wanted) {
  const auto ask = [this, &cell, wanted](std::future<void> before) {
    if (before.valid()) {
      before.get();
    }
    if (cell.result) {
      cell.truth_of_trace.assign(cell.result->traces.size(), nullptr);
    }
    if (wanted.oracle) {
      addTruths(cell);
    }
    if (wanted.geometry) {
      addGeometry(cell, geometry_, wanted.true_depth);
    }
  };
  last_ = std::async(waits_ ? std::launch::deferred : std::launch::async, ask, std::move(last_));
}

void TruthLane::finish() {
  if (last_.valid()) {
    last_.get();
  }
}

}  // namespace ssrkit
