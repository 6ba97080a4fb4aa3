// The ledger for people: one row for each buffer and pair of devices.
#pragma once

#include <string>
#include <vector>

#include "check/ledger.h"

namespace ssrkit {

// The words of one row, in the order of ledgerHeadings(): "hit (hiz)", "gl-osmesa : vk-lavapipe", ...
[[nodiscard]] std::vector<std::string> ledgerHeadings();
[[nodiscard]] std::vector<std::vector<std::string>> ledgerRows(const Ledger& ledger);

// The same with the stages of a buffer added up.
[[nodiscard]] Ledger overStages(const Ledger& ledger);

// For the terminal, over all stages: a line for each pair of devices whose buffers are all identical, and for
// the other pairs a line for each buffer that differs, the first 40 of them. At most 100 columns, ends with a
// line feed; empty without entries.
[[nodiscard]] std::string ledgerTable(const Ledger& ledger);

}  // namespace ssrkit
