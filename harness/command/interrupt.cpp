#include "command/interrupt.h"

#include <unistd.h>

#include <csignal>

#include "base/atomic_file.h"
#include "base/process_groups.h"

namespace ssrkit {

namespace {

extern "C" void onSignal(int signal) {
  killAllGroups();
  removeUnfinishedFiles();
  constexpr char kText[] = "\nssrkit: interrupted; finished files are whole, unfinished ones were removed\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, kText, sizeof(kText) - 1);
  _exit(128 + signal);
}

}  // namespace

void endCleanlyOnSignals() {
  struct sigaction action {};
  action.sa_handler = onSignal;
  sigfillset(&action.sa_mask);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    sigaction(signal, &action, nullptr);
  }
  // Whoever started this program may ignore it, and exec hands that on: then no child leaves its exit code.
  std::signal(SIGCHLD, SIG_DFL);
  // A full disk or a file-size limit must come back as an error of write(), a closed pipe likewise.
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
}

}  // namespace ssrkit
