#include "report/ledger_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "report/table_text.h"

namespace ssrkit {

namespace {

constexpr std::size_t kTextColumnCount = 2;

std::string pairText(const LedgerKey& key) {
  return key.device + " : " + key.other + (key.input.empty() ? "" : ", given " + key.input);
}

std::string bufferText(const LedgerKey& key) {
  return key.stage.empty() ? key.buffer : key.stage + " " + key.buffer;
}

std::vector<std::string> rowOf(const LedgerKey& key, const LedgerEntry& entry) {
  const double share =
      entry.compared == 0 ? 1.0 : static_cast<double>(entry.identical) / static_cast<double>(entry.compared);
  const bool has_distance = entry.compared > entry.flips;
  const auto distance = [&](std::uint64_t ulps) { return has_distance ? countText(ulps) : "-"; };
  return {pairText(key),
          bufferText(key),
          countText(entry.compared),
          percentText(share, 2),
          distance(entry.percentile(0.5)),
          distance(entry.percentile(0.99)),
          distance(entry.max_ulps),
          has_distance ? fmt::format("{:.2g}", entry.max_relative) : "-",
          countText(entry.flips)};
}

// Pairs of devices whose buffers are all the same, with how many buffers and texels.
struct TwinCount {
  std::size_t buffers = 0;
  std::size_t texels = 0;
  bool all_identical = true;
};

std::map<std::string, TwinCount> twinsOf(const Ledger& ledger) {
  std::map<std::string, TwinCount> twins;
  for (const auto& [key, entry] : ledger) {
    TwinCount& twin = twins[pairText(key)];
    ++twin.buffers;
    twin.texels += entry.compared;
    twin.all_identical = twin.all_identical && entry.identical == entry.compared;
  }
  return twins;
}

std::string ledgerLine(const std::vector<std::string>& row) {
  constexpr std::array<std::size_t, 9> kWidths = {29, 22, 6, 6, 5, 5, 7, 7, 5};
  std::string line;
  for (std::size_t column = 0; column < kWidths.size(); ++column) {
    const std::string cell = cellText(row[column], kWidths.at(column));
    const std::string blanks(kWidths.at(column) - std::min(columnsOf(cell), kWidths.at(column)), ' ');
    line.append(column == 0 ? 0 : 1, ' ');
    line += column < kTextColumnCount ? cell + blanks : blanks + cell;
  }
  return line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
}

}  // namespace

std::vector<std::string> ledgerHeadings() {
  return {"devices", "buffer", "texels", "same %", "p50", "p99", "max ulp", "max rel", "flips"};
}

std::vector<std::vector<std::string>> ledgerRows(const Ledger& ledger) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& [key, entry] : ledger) {
    rows.push_back(rowOf(key, entry));
  }
  return rows;
}

Ledger overStages(const Ledger& ledger) {
  Ledger sums;
  for (const auto& [key, entry] : ledger) {
    LedgerKey of_all = key;
    of_all.stage.clear();
    sums[of_all] += entry;
  }
  return sums;
}

std::string ledgerTable(const Ledger& ledger) {
  constexpr std::size_t kMostRows = 40;
  const Ledger sums = overStages(ledger);
  std::string text;
  for (const auto& [pair, twin] : twinsOf(sums)) {
    if (twin.all_identical) {
      text += cellText(fmt::format("{}: {} buffers are bit-identical ({} texels)", pair, twin.buffers,
                                   countText(twin.texels)),
                       100) +
              "\n";
    }
  }
  std::size_t row_count = 0;
  for (const auto& [key, entry] : sums) {
    if (entry.identical == entry.compared) {
      continue;
    }
    if (row_count == 0) {
      text += ledgerLine(ledgerHeadings());
    }
    text += ++row_count <= kMostRows ? ledgerLine(rowOf(key, entry)) : "";
  }
  if (row_count > kMostRows) {
    text += fmt::format("... and {} rows more, in report.html\n", row_count - kMostRows);
  }
  return text;
}

}  // namespace ssrkit
