// The ledger for people: one row for each buffer and pair of devices.
#pragma once

#include <string>
#include <vector>

#include "check/ledger.h"

namespace ssrkit {

// The words of one row, in the order of ledgerHeadings(): "hit (hiz)", "gl-osmesa : vk-lavapipe", ...
[[nodiscard]] std::vector<std::string> ledgerHeadings();
[[nodiscard]] std::vector<std::vector<std::string>> ledgerRows(const Ledger& ledger);

// At most 100 columns, ends with a line feed; empty without entries. Pairs whose buffers are all identical
// take one line, so that what differs stands out.
[[nodiscard]] std::string ledgerTable(const Ledger& ledger);

}  // namespace ssrkit
