#pragma once

#include <functional>

#include "command/bench.h"

namespace CLI {
class App;
}  // namespace CLI

namespace ssrkit {

// Adds the command `bench`; `command` becomes what is to be run once its options have been read. Both outlive
// the reading.
void addBench(CLI::App& app, BenchOptions& options, std::function<Expected<int>()>& command);

}  // namespace ssrkit
