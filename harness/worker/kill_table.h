// The process groups of all workers alive, where a signal handler can find them (killAllWorkers in
// supervisor.h).
#pragma once

#include <sys/types.h>

namespace ssrkit {

void rememberWorker(pid_t group);

// Called before the process is waited for: until then its number cannot be given to another process.
void forgetWorker(pid_t group);

}  // namespace ssrkit
