// Jobs over G-buffers that are made by formula or at random.
#pragma once

#include "frame/job.h"

namespace ssrkit {

// A G-buffer of blocks of random distance and direction: rays of every direction, towards the camera too.
[[nodiscard]] Job randomBlocks(Size size);

// The same directions over rolling hills with holes in them.
[[nodiscard]] Job randomTerrain(Size size);

// A level mirror floor one metre below the camera, f = 2, and a wall at this distance; inf: no wall.
[[nodiscard]] Job floorAndWall(Size size, double wall_m);

}  // namespace ssrkit
