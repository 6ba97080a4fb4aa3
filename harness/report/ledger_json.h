// The ledger as part of JSON files, and read back from the results of another process.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "base/error.h"
#include "check/ledger.h"
#include "report/json_parts.h"

namespace ssrkit {

// A list with one object an entry, in the order of the keys (docs/formats.md).
[[nodiscard]] Json ledgerJson(const Ledger& ledger);

// What ledgerJson() wrote. `where` names the file in errors.
[[nodiscard]] Expected<Ledger> ledgerFromJson(const Json& json, const std::string& where);

}  // namespace ssrkit
