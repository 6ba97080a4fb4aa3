// Reads the files of tests/mutants and tests/wheats (docs/mutants.md). As strict as expectation files.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "mutation/mutant.h"

namespace ssrkit {

// One file's content. `file` is its path: the mutant has its name, and a whole shader stands beside it.
[[nodiscard]] Expected<Mutant> readMutant(std::string_view content, const std::filesystem::path& file,
                                          bool is_wheat);

// Every *.toml of a folder, by name.
[[nodiscard]] Expected<std::vector<Mutant>> loadMutants(const std::filesystem::path& folder, bool are_wheats);

}  // namespace ssrkit
