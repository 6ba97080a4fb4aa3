#include "report/table.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <numeric>
#include <string_view>
#include <utility>
#include <vector>

#include "report/table_text.h"

namespace ssrkit {

namespace {

enum Column : std::size_t {
  kStage,
  kDevice,
  kOutcome,
  kHits,
  kSame,
  kNear,
  kWrong,
  kFalse,
  kMissed,
  kLeak,
  kMean,
  kP95,
  kCpu,
  kWall,
  kColumnCount
};

constexpr std::size_t kIndent = 2;
constexpr std::size_t kFirstRightAligned = kHits;

// Columns that share a word above their own heading.
struct Span {
  Column first;
  Column last;
  std::string_view text;
};
constexpr std::array<Span, 3> kSpans = {
    {{kSame, kLeak, "against Oracle A, rays"}, {kMean, kP95, "lookups/ray"}, {kCpu, kWall, "trace, ms"}}};

using Line = std::array<std::string, kColumnCount>;
using Widths = std::array<std::size_t, kColumnCount>;

const Line& runHeadings() {
  static const Line line = {"stage", "device", "checks", "hits %", "SAME %", "NEAR", "WRONG",
                            "FALSE", "MISSED", "LEAK",   "mean",   "p95",    "CPU",  "wall"};
  return line;
}

Line runLine(const RunRow& row) {
  Line line;
  std::ranges::fill(line, std::string("-"));
  line[kStage] = row.stage;
  line[kDevice] = row.device;
  line[kOutcome] = name(row.outcome);
  if (row.summary && row.summary->traced_rays > 0) {
    const TraceSummary& summary = *row.summary;
    const auto hits = static_cast<double>(summary.classes.at(static_cast<std::size_t>(RayClass::kHit)));
    line[kHits] = percentText(hits / static_cast<double>(summary.traced_rays), 1);
    line[kMean] = measureText(summary.lookups.mean);
    line[kP95] = countText(static_cast<std::size_t>(summary.lookups.p95));
  }
  if (row.summary && row.summary->verdicts) {
    const VerdictCounts& counts = *row.summary->verdicts;
    constexpr std::array<std::pair<Column, Verdict>, 5> kCounted = {{{kNear, Verdict::kNear},
                                                                     {kWrong, Verdict::kWrong},
                                                                     {kFalse, Verdict::kFalseHit},
                                                                     {kMissed, Verdict::kMissedHit},
                                                                     {kLeak, Verdict::kLeak}}};
    for (const auto& [column, verdict] : kCounted) {
      line[column] = countText(counts.at(static_cast<std::size_t>(verdict)));
    }
    if (const auto same = sameFraction(counts)) {
      line[kSame] = percentText(*same, 2);
    }
  }
  if (const auto cost = traceCost(row.passes)) {
    line[kCpu] = measureText(cost->cpu_ms);
    line[kWall] = measureText(cost->wall_ms);
  }
  return line;
}

std::size_t totalWidth(const Widths& widths) {
  return std::accumulate(widths.begin(), widths.end(), kIndent + kColumnCount - 1);
}

std::size_t widthOf(const Span& span, const Widths& widths) {
  return std::accumulate(widths.begin() + span.first, widths.begin() + span.last + 1,
                         std::size_t{span.last - span.first});
}

// As wide as the widest cell; when that is too wide for the screen, names give way, then outcome words.
Widths widthsFor(std::span<const Line> lines, std::size_t screen_width) {
  Widths widths{};
  for (const Line& line : lines) {
    for (std::size_t i = 0; i < kColumnCount; ++i) {
      widths[i] = std::max(widths[i], columnsOf(line[i]));
    }
  }
  for (const Span& span : kSpans) {
    while (widthOf(span, widths) < span.text.size()) {
      ++widths[span.first];
    }
  }
  constexpr std::array<std::pair<Column, std::size_t>, 3> kGiveWay = {
      {{kDevice, 10}, {kStage, 5}, {kOutcome, 6}}};
  for (const auto& [column, narrowest] : kGiveWay) {
    while (totalWidth(widths) > screen_width && widths[column] > narrowest) {
      --widths[column];
    }
  }
  return widths;
}

std::string_view outcomeColour(Outcome outcome) {
  switch (outcome) {
    case Outcome::kPass:
      return "\x1b[32m";
    case Outcome::kSkip:
      return "";
    case Outcome::kWarn:
    case Outcome::kFlake:
    case Outcome::kXfail:
    case Outcome::kInconclusive:
      return "\x1b[33m";
    default:
      return "\x1b[31m";
  }
}

std::string printed(const Line& line, const Widths& widths, std::string_view outcome_colour) {
  std::string text(kIndent, ' ');
  for (std::size_t i = 0; i < kColumnCount; ++i) {
    const std::string cell = cellText(line[i], widths[i]);
    const std::string blanks(widths[i] - columnsOf(cell), ' ');
    const bool is_coloured = i == kOutcome && !outcome_colour.empty();
    const std::string shown = is_coloured ? fmt::format("{}{}\x1b[0m", outcome_colour, cell) : cell;
    text += i >= kFirstRightAligned ? blanks + shown : shown + blanks;
    text += i + 1 < kColumnCount ? " " : "";
  }
  return text + "\n";
}

std::string spanLine(const Widths& widths) {
  std::string text;
  for (const Span& span : kSpans) {
    const std::size_t end =
        std::accumulate(widths.begin(), widths.begin() + span.last + 1, kIndent + span.last);
    text += fmt::format("{:>{}}", span.text, end - text.size());
  }
  return text + "\n";
}

std::string headingOf(const RunRow& row, std::size_t screen_width) {
  std::string text = fmt::format("{} {}x{}", row.scene, row.size.width, row.size.height);
  if (!row.case_name.empty()) {
    text += " " + row.case_name;
  }
  return cellText(text, screen_width) + "\n";
}

}  // namespace

bool wantsColour(int fd) {
  const char* const no_colour = std::getenv("NO_COLOR");
  const char* const term = std::getenv("TERM");
  const bool is_refused =
      (no_colour != nullptr && *no_colour != '\0') || (term != nullptr && std::string_view(term) == "dumb");
  return !is_refused && isatty(fd) == 1;
}

std::string runTable(std::span<const RunRow> rows, const TableStyle& style) {
  if (rows.empty()) {
    return {};
  }
  std::vector<Line> lines = {runHeadings()};
  for (const RunRow& row : rows) {
    lines.push_back(runLine(row));
  }
  const auto screen_width = static_cast<std::size_t>(std::max(style.width, 1));
  const Widths widths = widthsFor(lines, screen_width);
  std::string text = spanLine(widths) + printed(lines[0], widths, "");
  std::string heading;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (std::string own = headingOf(rows[i], screen_width); own != heading) {
      text += own;
      heading = std::move(own);
    }
    text += printed(lines[i + 1], widths, style.colour ? outcomeColour(rows[i].outcome) : "");
  }
  return text;
}

}  // namespace ssrkit
