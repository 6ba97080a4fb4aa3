#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "base/text.h"
#include "report/claims_report.h"
#include "report/pass_table.h"
#include "report/table_text.h"

namespace ssrkit {

namespace {

constexpr std::size_t kLabelColumns = 13;  // of a claim's own lines

// Figures that say the same on several devices are one line.
struct FigureLine {
  const ClaimFigure* figure = nullptr;
  std::vector<std::string> devices;
};

std::string checkPlace(const CheckResult& check) {
  std::string text = fmt::format("{} {}x{}", check.scene, check.size.width, check.size.height);
  for (const std::string* part : {&check.stage, &check.case_name}) {
    text += part->empty() ? "" : " " + *part;
  }
  return text;
}

std::string valueWithInterval(const CheckResult& check) {
  if (!check.value) {
    return "-";
  }
  const std::string value = fmt::format("{:.4g}", *check.value);
  return check.interval
             ? fmt::format("{} ({:.4g}..{:.4g})", value, check.interval->first, check.interval->second)
             : value;
}

// The same to every digit that is shown.
bool isSameFigure(const ClaimFigure& a, const ClaimFigure& b) {
  return a.check.id == b.check.id && checkPlace(a.check) == checkPlace(b.check) &&
         valueWithInterval(a.check) == valueWithInterval(b.check) && a.verdict == b.verdict;
}

std::vector<FigureLine> figureLines(const ClaimResult& result) {
  std::vector<FigureLine> lines;
  for (const ClaimFigure& figure : result.figures) {
    const auto known = std::ranges::find_if(
        lines, [&](const FigureLine& line) { return isSameFigure(*line.figure, figure); });
    if (known != lines.end()) {
      known->devices.push_back(figure.check.device);
    } else {
      lines.push_back({&figure, {figure.check.device}});
    }
  }
  return lines;
}

std::string figureName(const Claim& claim, const CheckResult& check) {
  return check.id.substr(std::min(check.id.size(), claim.test.id.size() + 1));
}

// A label, and words broken to the lines' width beside it.
std::string paragraph(std::string_view label, const std::string& words, std::size_t width,
                      std::size_t label_columns = kLabelColumns) {
  std::string text = fmt::format("  {:<{}}", label, label_columns);
  std::size_t column = text.size();
  bool is_first = true;
  for (const std::string& word : split(words, ' ')) {
    if (!is_first && column + 1 + columnsOf(word) > width) {
      text += fmt::format("\n{:{}}", "", label_columns + 2);
      column = label_columns + 2;
      is_first = true;
    }
    text += (is_first ? "" : " ") + word;
    column += columnsOf(word) + (is_first ? 0 : 1);
    is_first = false;
  }
  return text + "\n";
}

// What each figure is, and what it takes to confirm and to refute.
std::string figuresOf(const ClaimReport& report, std::size_t width) {
  std::string text;
  std::vector<std::string> told;
  std::size_t columns = kLabelColumns;
  for (const ClaimFigure& figure : report.result.figures) {
    columns = std::max(columns, figureName(report.claim, figure.check).size() + 2);
  }
  for (const ClaimFigure& figure : report.result.figures) {
    const std::string name = figureName(report.claim, figure.check);
    const bool was_asked = !figure.decides || !confirmingText(figure).empty();
    if (!was_asked || std::ranges::find(told, name) != told.end()) {
      continue;
    }
    told.push_back(name);
    const std::string bounds =
        confirmingText(figure).empty()
            ? "shown only"
            : fmt::format("confirmed at {}, refuted at {}", confirmingText(figure), refutingText(figure));
    text += paragraph(name, fmt::format("{} ({}): {}", figure.check.metric, figure.check.unit, bounds), width,
                      columns);
  }
  return text;
}

using Row = std::array<std::string, 5>;

std::string tableOf(const ClaimReport& report) {
  std::vector<Row> rows = {{"figure", "of", "on", "value", "says"}};
  for (const FigureLine& line : figureLines(report.result)) {
    const ClaimFigure& figure = *line.figure;
    rows.push_back({figureName(report.claim, figure.check), checkPlace(figure.check),
                    fmt::format("{}", fmt::join(line.devices, " ")), valueWithInterval(figure.check),
                    figure.decides ? name(figure.verdict) : "-"});
  }
  std::array<std::size_t, 5> widths{};
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths.at(i) = std::max(widths.at(i), columnsOf(row.at(i)));
    }
  }
  std::string text;
  for (const Row& row : rows) {
    std::string line = "  ";
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += fmt::format("{}{:{}}", row.at(i), "", widths.at(i) - columnsOf(row.at(i)) + 2);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

const char* claimColour(ClaimVerdict verdict) {
  switch (verdict) {
    case ClaimVerdict::kConfirmed:
      return "\033[32m";
    case ClaimVerdict::kRefuted:
      return "\033[33m";
    case ClaimVerdict::kInconclusive:
      return "\033[36m";
    case ClaimVerdict::kNotMeasured:
      return "\033[31m";
  }
  return "";
}

std::string boundsText(std::optional<double> min, std::optional<double> max) {
  if (min && max) {
    return fmt::format("{:g}..{:g}", *min, *max);
  }
  return min ? fmt::format(">= {:g}", *min) : max ? fmt::format("<= {:g}", *max) : "";
}

}  // namespace

std::string confirmingText(const ClaimFigure& figure) {
  return boundsText(figure.check.min, figure.check.max);
}

std::string refutingText(const ClaimFigure& figure) {
  const auto& [above, below] = figure.refuting;
  if (above && below) {
    return fmt::format("<= {:g} or >= {:g}", *below, *above);
  }
  return boundsText(above, below);
}

std::string verdictText(const ClaimReport& report) {
  const ClaimVerdict verdict = report.result.verdict;
  const auto settles = std::ranges::find_if(report.result.figures, [&](const ClaimFigure& figure) {
    return figure.decides && figure.verdict == verdict;
  });
  std::string text = name(verdict);
  if (const auto count = std::ranges::count_if(report.result.figures, &ClaimFigure::decides);
      verdict == ClaimVerdict::kConfirmed && count > 1) {
    text += fmt::format(" by all {} figures that decide, as by", count);
  } else {
    text += ":";
  }
  if (settles != report.result.figures.end()) {
    const CheckResult& check = settles->check;
    const std::string bounds = confirmingText(*settles).empty()
                                   ? ""
                                   : fmt::format(" (confirmed at {}, refuted at {})",
                                                 confirmingText(*settles), refutingText(*settles));
    text += fmt::format(" {} = {} {}{}, {} on {}", figureName(report.claim, check), valueWithInterval(check),
                        check.unit, bounds, checkPlace(check), check.device);
    text += verdict == ClaimVerdict::kNotMeasured
                ? ": " + (check.remark.empty() ? check.message : check.remark)
                : "";
  }
  const std::string& meaning = verdict == ClaimVerdict::kConfirmed ? report.claim.if_confirmed
                               : verdict == ClaimVerdict::kRefuted ? report.claim.if_refuted
                                                                   : "";
  return meaning.empty() ? text + "." : text + ". " + meaning;
}

std::string claimText(const ClaimReport& report, const TableStyle& style) {
  const Claim& claim = report.claim;
  const ClaimVerdict verdict = report.result.verdict;
  const auto width = static_cast<std::size_t>(style.width);
  const std::string word =
      style.colour ? fmt::format("{}{}\033[0m", claimColour(verdict), name(verdict)) : name(verdict);
  std::string text = fmt::format("{}: {}\n", claim.name, word);
  text += paragraph("claim", fmt::format("{} ({})", claim.says, claim.source), width);
  text += paragraph("hypothesis", claim.test.about, width);
  text += figuresOf(report, width);
  text += tableOf(report);
  text += passTable(report.frames, report.rows);
  text += paragraph("verdict", verdictText(report), width);
  if (verdict != claim.finding) {
    text += paragraph("noted", fmt::format("the claim's file says {}", name(claim.finding)), width);
  }
  return text + paragraph("again", report.again, width);
}

std::string verdictCounts(const ClaimsReport& report) {
  std::vector<std::string> parts;
  for (const ClaimVerdict verdict : {ClaimVerdict::kConfirmed, ClaimVerdict::kRefuted,
                                     ClaimVerdict::kInconclusive, ClaimVerdict::kNotMeasured}) {
    const auto count = std::ranges::count_if(
        report.claims, [&](const ClaimReport& claim) { return claim.result.verdict == verdict; });
    if (count > 0) {
      parts.push_back(fmt::format("{} {}", count, name(verdict)));
    }
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace ssrkit
