#include "base/background.h"

#include <sys/resource.h>
#include <unistd.h>

namespace ssrkit {

void workInBackground() {
  constexpr int kLeast = 19;
  static_cast<void>(setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kLeast));
}

}  // namespace ssrkit
