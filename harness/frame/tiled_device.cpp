#include "frame/tiled_device.h"

#include "device/pass_clock.h"

namespace ssrkit {

std::vector<Rect> tilesOf(const Rect& viewport, int columns, int rows) {
  std::vector<Rect> tiles;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const int left = viewport.width * column / columns;
      const int top = viewport.height * row / rows;
      const Rect tile{.x = viewport.x + left,
                      .y = viewport.y + top,
                      .width = viewport.width * (column + 1) / columns - left,
                      .height = viewport.height * (row + 1) / rows - top};
      if (tile.width > 0 && tile.height > 0) {
        tiles.push_back(tile);
      }
    }
  }
  return tiles;
}

Expected<PassTime> TiledDevice::draw(const PassDesc& pass) {
  if (pass.vertices != nullptr) {
    return behind().draw(pass);
  }
  PassDesc of_tile = pass;
  PassTime sum{.wall_ns = 0, .cpu_ns = 0, .device_ns = 0};
  for (const Rect& tile : tilesOf(pass.viewport, columns_, rows_)) {
    of_tile.scissor = tile;
    const auto time = behind().draw(of_tile);
    if (!time) {
      return time;
    }
    sum += *time;
    // Clears are of the whole image: the first tile's is for all.
    for (Attachment& attachment : of_tile.colour) {
      attachment.clear.reset();
    }
    if (of_tile.depth) {
      of_tile.depth->clear.reset();
    }
  }
  return sum;
}

}  // namespace ssrkit
