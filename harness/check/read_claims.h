// Reads claim files: expectation files with a [claim] section, and for each [[expect]] what refutes it. As
// strict.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "check/claim.h"
#include "check/read_expectations.h"

namespace ssrkit {

// One file's content. `file` is the name that messages show.
[[nodiscard]] Expected<Claim> readClaim(std::string_view content, const std::string& file,
                                        const KnownNames& known = {});

// Every *.toml of a folder, sorted by name, each named after its claim.
[[nodiscard]] Expected<std::vector<Claim>> loadClaims(const std::filesystem::path& folder,
                                                      const KnownNames& known = {});

}  // namespace ssrkit
