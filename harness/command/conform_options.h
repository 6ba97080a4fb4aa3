// The options of `conform` and `conform merge`.
#pragma once

#include <functional>

#include "base/error.h"
#include "command/conform.h"

namespace CLI {
class App;
}  // namespace CLI

namespace ssrkit {

// Adds both to `app`. Whichever is chosen puts itself into `command`. All four must outlive the parsing.
void addConform(CLI::App& app, ConformOptions& options, ConformMergeOptions& merge,
                std::function<Expected<int>()>& command);

}  // namespace ssrkit
