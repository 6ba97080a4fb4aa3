// Independent pieces of work on several threads.
#pragma once

#include <functional>

namespace ssrkit {

// Does piece i of the work, i from 0.
using Lane = std::function<void(int)>;

// Hands out the pieces 0 .. `count` - 1, each once and in order, to whichever lane is free. There are up to
// `lane_count` lanes (0: one for each core) at once, this thread's among them; `make_lane(number)` is called
// in the lane's own thread and makes what it keeps from piece to piece. Where no more threads are to be had,
// those that there are do the work. An exception ends the handing out, and is thrown here once every lane has
// ended; the first one, if there are several.
void shareOut(int count, int lane_count, const std::function<Lane(int)>& make_lane);

// The same, with lanes that keep nothing.
void forEachInParallel(int count, int lane_count, const Lane& piece);

}  // namespace ssrkit
