// The process groups of all children alive, where a signal handler can find them. Each child leads a group of
// its own, so that what it starts can be ended with it; the terminal's Ctrl-C does not reach such a group.
#pragma once

#include <sys/types.h>

namespace ssrkit {

void rememberGroup(pid_t group);

// Called before the process that leads it is collected: until then its number cannot be given to another one.
void forgetGroup(pid_t group);

// Kills every group that is remembered. Only calls that are safe in a signal handler.
void killAllGroups() noexcept;

}  // namespace ssrkit
