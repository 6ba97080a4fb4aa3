#pragma once

#include <functional>

#include "base/error.h"
#include "command/run.h"

namespace CLI {
class App;
}  // namespace CLI

namespace ssrkit {

// Adds the command `run`; `command` becomes what is to be run once its options have been read. All must
// outlive the parsing.
void addRun(CLI::App& app, RunOptions& options, std::function<Expected<int>()>& command);

}  // namespace ssrkit
