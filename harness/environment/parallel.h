// Independent pieces of work on all cores. The result must not depend on who does what: each piece writes its
// own.
#pragma once

#include <functional>

namespace ssrkit {

// Calls `piece(0)` .. `piece(count - 1)`, each once, in any order, from as many threads as there are cores.
void forEachInParallel(int count, const std::function<void(int)>& piece);

}  // namespace ssrkit
