#pragma once

#include <filesystem>
#include <string>

#include "base/error.h"
#include "command/kit_paths.h"
#include "mutation/mutant.h"

namespace ssrkit {

// The room of the file that a mutant of the harness changes: "check".
[[nodiscard]] std::string roomOf(const Mutant& mutant);

// Compiles the changed file with the flags of compile_commands.json and links the unit-test program of its
// room with it, which stands in `folder` then. Neither the source tree nor the build is touched.
[[nodiscard]] Expected<std::filesystem::path> buildMutant(const Mutant& mutant, const KitPaths& paths,
                                                          const std::filesystem::path& folder);

}  // namespace ssrkit
