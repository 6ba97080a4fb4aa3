// A device that draws full-screen passes tile by tile.
#pragma once

#include <vector>

#include "device/forwarding_device.h"

namespace ssrkit {

// Cuts the pass into `columns` x `rows` tiles by the scissor, the viewport staying whole: every texel is
// drawn once, and what a texel is cannot depend on the tile that it lies in. Passes over vertices are left
// whole.
class TiledDevice final : public ForwardingDevice {
 public:
  TiledDevice(Device& device, int columns, int rows)
      : ForwardingDevice(device), columns_(columns), rows_(rows) {}

  // The time is the sum of the tiles'.
  [[nodiscard]] Expected<PassTime> draw(const PassDesc& pass) override;

 private:
  int columns_;
  int rows_;
};

// The tiles of a viewport from the upper left, row by row; none is empty, together they cover it once.
[[nodiscard]] std::vector<Rect> tilesOf(const Rect& viewport, int columns, int rows);

}  // namespace ssrkit
