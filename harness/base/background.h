// Work that nobody waits for.
#pragma once

namespace ssrkit {

// From here on the calling thread, and the threads that it starts, run where nothing else does: other threads
// of this process and its children go first. For good: a thread may not take its priority back
// (setpriority(2); on Linux a priority is one thread's). Where a sandbox forbids it, nothing changes.
void workInBackground();

}  // namespace ssrkit
