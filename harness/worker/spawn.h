#pragma once

#include "worker/child_process.h"

namespace ssrkit {

// Starts the command with descriptor 3 = `socket` and 2 = `stderr_pipe`, and returns its process number,
// which is its process group's too. Fails with the system's reason when the executable cannot be run.
[[nodiscard]] Expected<pid_t> spawn(const ChildCommand& command, int socket, int stderr_pipe);

}  // namespace ssrkit
