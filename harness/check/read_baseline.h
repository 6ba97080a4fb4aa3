// Reads lists of known failures. As strict as expectation files.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "check/baseline.h"
#include "check/read_expectations.h"

namespace ssrkit {

// One file's content, which may list nothing. `file` is the name that messages show. A device without a
// wildcard must be among the known ones, where any are given.
[[nodiscard]] Expected<std::vector<KnownFailure>> readBaseline(std::string_view content,
                                                               const std::string& file,
                                                               const KnownNames& known = {});

[[nodiscard]] Expected<std::vector<KnownFailure>> loadBaseline(const std::filesystem::path& file,
                                                               const KnownNames& known = {});

}  // namespace ssrkit
