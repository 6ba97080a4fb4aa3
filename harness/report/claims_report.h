// What `compare` found out of claims, as plain data.
#pragma once

#include <string>
#include <vector>

#include "check/claim.h"
#include "check/judge_claim.h"
#include "report/run_report.h"
#include "report/table.h"

namespace ssrkit {

struct ClaimReport {
  Claim claim;
  ClaimResult result;
  std::vector<FrameRow> frames;  // with the rows: the passes' times, for claims about time
  std::vector<RunRow> rows;
  std::string again;  // the command that measures it again
};

struct ClaimsReport {
  std::string kit_version;
  std::string started;               // UTC, ISO 8601
  std::vector<std::string> command;  // argv
  std::vector<DeviceRow> devices;
  std::vector<ClaimReport> claims;
};

// Why the verdict is what it is: the figure that settles it, with its bounds, and what the claim's file says
// to it.
[[nodiscard]] std::string verdictText(const ClaimReport& report);

// "<= 0.02 FLIP": what confirms a figure, and what refutes it; empty where nothing does.
[[nodiscard]] std::string confirmingText(const ClaimFigure& figure);
[[nodiscard]] std::string refutingText(const ClaimFigure& figure);

// Several lines on one claim, as the terminal shows them.
[[nodiscard]] std::string claimText(const ClaimReport& report, const TableStyle& style);

// "3 confirmed, 4 refuted, 1 inconclusive"
[[nodiscard]] std::string verdictCounts(const ClaimsReport& report);

// DIR/claims.json (docs/formats.md).
inline constexpr int kClaimsSchemaVersion = 1;
[[nodiscard]] std::string claimsJson(const ClaimsReport& report);

// DIR/report.html: one file that opens from the disk, without a network.
[[nodiscard]] std::string claimsHtml(const ClaimsReport& report);

}  // namespace ssrkit
