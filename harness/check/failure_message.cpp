#include "check/failure_message.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace ssrkit {

namespace {

constexpr std::size_t kShownFindings = 10;

std::string spread(const Measurement& measurement) {
  int low_x = measurement.findings.front().x;
  int low_y = measurement.findings.front().y;
  int high_x = low_x;
  int high_y = low_y;
  for (const Finding& finding : measurement.findings) {
    low_x = std::min(low_x, finding.x);
    low_y = std::min(low_y, finding.y);
    high_x = std::max(high_x, finding.x);
    high_y = std::max(high_y, finding.y);
  }
  const double share = 100.0 * static_cast<double>(measurement.findings.size()) /
                       std::max(1.0, static_cast<double>(measurement.compared));
  return fmt::format("  spread    {} of {} {} ({:.3g} %), columns {} to {}, rows {} to {}\n",
                     measurement.findings.size(), measurement.compared, measurement.compared_what, share,
                     low_x, high_x, low_y, high_y);
}

std::string confusionLines(const Measurement& measurement) {
  std::string text;
  for (const auto& [classes, count] : measurement.confusion) {
    text += fmt::format("  classes   {:>8} x expected {}, yours {}\n", count, name(classes.first),
                        name(classes.second));
  }
  return text;
}

std::string table(const Measurement& measurement) {
  using Row = std::array<std::string, 4>;
  std::vector<Row> rows = {{"pixel", "yours", "expected", "delta"}};
  const std::size_t shown = std::min(kShownFindings, measurement.findings.size());
  for (std::size_t i = 0; i < shown; ++i) {
    const Finding& finding = measurement.findings[i];
    FindingText text = measurement.describe(finding);
    rows.push_back({fmt::format("({}, {})", finding.x, finding.y), std::move(text.yours),
                    std::move(text.expected), std::move(text.delta)});
  }
  std::array<std::size_t, 4> widths{};
  for (const Row& row : rows) {
    for (std::size_t column = 0; column < row.size(); ++column) {
      widths.at(column) = std::max(widths.at(column), row.at(column).size());
    }
  }
  std::string lines;
  for (const Row& row : rows) {
    std::string line = "   ";
    for (std::size_t column = 0; column < row.size(); ++column) {
      line += fmt::format(" {:<{}}", row.at(column), widths.at(column) + 1);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    lines += line + "\n";
  }
  if (measurement.findings.size() > shown) {
    lines += fmt::format("    ... and {} more\n", measurement.findings.size() - shown);
  }
  return lines;
}

std::string measuredText(const CheckResult& result) {
  return result.value ? fmt::format("{:.6g} {}", *result.value, result.unit) : "nothing";
}

}  // namespace

std::string failureMessage(const CheckResult& result, const Expectation& expectation,
                           Measurement measurement) {
  std::string text = fmt::format("{}: {}\n", name(result.outcome), fullName(result));
  text += fmt::format("  yours     {} = {}\n", result.metric, measuredText(result));
  const bool by_itself = expectation.truth.kind == TruthKind::kNone;
  text += fmt::format("  expected  {}{} ({})\n", boundText(result),
                      by_itself ? "" : ", against " + truthText(expectation.truth), expectation.where);
  if (!measurement.problem.empty()) {
    text += fmt::format("  problem   {}\n", measurement.problem);
  }
  if (!measurement.remark.empty()) {
    text += fmt::format("  note      {}\n", measurement.remark);
  }
  if (!measurement.findings.empty()) {
    std::ranges::stable_sort(measurement.findings, std::greater{}, &Finding::severity);
    text += spread(measurement) + confusionLines(measurement) + table(measurement);
  }
  if (measurement.cause) {
    if (const auto cause = measurement.cause()) {
      text += fmt::format("  likely    {}\n", *cause);
    }
  }
  if (!result.repro.empty()) {
    text += fmt::format("  again     {}\n", result.repro);
  }
  text.pop_back();
  return text;
}

}  // namespace ssrkit
