// The truths of a run's cells, found while later cells are drawn.
#pragma once

#include <future>

#include "command/scene_geometry.h"

namespace ssrkit {

struct WantedTruths {
  bool oracle = false;
  bool geometry = false;
  bool true_depth = false;  // with `geometry`: also what the camera truly sees
};

// Cells are asked about one after the other, in the order in which they were added, by one thread.
class TruthLane {
 public:
  // `waits`: nothing is asked before finish(), for runs that read clocks.
  TruthLane(SceneGeometry& geometry, bool waits) : geometry_(geometry), waits_(waits) {}

  // The cell is complete but for its truths, stays where it is, and is left alone until finish(). Errors
  // become the cell's.
  void add(CellRun& cell, const WantedTruths& wanted);

  void finish();

 private:
  SceneGeometry& geometry_;
  bool waits_;
  std::future<void> last_;
};

}  // namespace ssrkit
