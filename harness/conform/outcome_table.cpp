#include "conform/outcome_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "report/table_text.h"

namespace ssrkit {

namespace {

constexpr std::size_t kWidth = 100;
constexpr std::size_t kShortestLabel = 24;

// Of one row and one device.
using Checks = std::vector<CheckResult>;

struct Row {
  std::string label;
  std::map<std::string, Checks> by_device;
};

struct TestRows {
  std::string test;
  std::vector<Row> rows;  // one an expectation
};

bool isWell(const CheckResult& check) {
  return check.outcome == Outcome::kPass || check.outcome == Outcome::kWarn ||
         check.outcome == Outcome::kXfail;
}

template <class Item>
Item& itemOf(std::vector<Item>& items, std::string Item::*name, const std::string& wanted) {
  const auto found = std::ranges::find(items, wanted, name);
  if (found != items.end()) {
    return *found;
  }
  items.emplace_back();
  items.back().*name = wanted;
  return items.back();
}

std::vector<TestRows> rowsOf(std::span<const CellRecord> records) {
  std::vector<TestRows> tests;
  for (const CellRecord& record : records) {
    const std::string test = record.id.substr(0, record.id.find('/'));
    TestRows& rows = itemOf(tests, &TestRows::test, test);
    for (const CheckResult& check : record.checks) {
      const std::string label =
          check.id.starts_with(test + ".") ? check.id.substr(test.size() + 1) : check.id;
      itemOf(rows.rows, &Row::label, label).by_device[check.device].push_back(check);
    }
  }
  return tests;
}

// One row where all is well, else one a stage.
std::vector<Row> splitByStage(const Row& row) {
  const bool is_well = std::ranges::all_of(
      row.by_device, [](const auto& entry) { return std::ranges::all_of(entry.second, isWell); });
  if (is_well) {
    return {row};
  }
  std::vector<Row> rows;
  for (const auto& [device, checks] : row.by_device) {
    for (const CheckResult& check : checks) {
      const std::string label = check.stage.empty() ? row.label : row.label + " " + check.stage;
      itemOf(rows, &Row::label, label).by_device[device].push_back(check);
    }
  }
  return rows;
}

// "gl-osmesa" takes two lines: "gl" and "osmesa".
struct Column {
  std::string device;
  std::string upper;
  std::string lower;
  std::size_t width = 0;
};

std::vector<Column> columnsOf(std::span<const CellRecord> records) {
  constexpr std::size_t kNarrowest = 8;
  std::vector<Column> columns;
  for (const CellRecord& record : records) {
    const std::string device = record.id.substr(record.id.rfind('/') + 1);
    if (std::ranges::find(columns, device, &Column::device) == columns.end()) {
      const std::size_t dash = device.find('-');
      const bool is_split = dash != std::string::npos;
      Column column{.device = device,
                    .upper = is_split ? device.substr(0, dash) : "",
                    .lower = is_split ? device.substr(dash + 1) : device};
      column.width = std::max(kNarrowest, column.lower.size());
      columns.push_back(std::move(column));
    }
  }
  return columns;
}

std::string fieldText(const Checks& checks, std::size_t width) {
  const auto well = static_cast<std::size_t>(std::ranges::count_if(checks, isWell));
  if (well == checks.size()) {
    return fmt::format("{}", well);
  }
  const Outcome gravest = gravestOutcome(checks);
  if (std::ranges::count(checks, Outcome::kSkip, &CheckResult::outcome) == std::ssize(checks)) {
    return "skip";
  }
  // "3 inconclusive", else "3 inco", else "inconclu"
  for (const std::size_t letters : {std::string::npos, std::size_t{4}}) {
    std::string text =
        fmt::format("{} {}", checks.size() - well, std::string(name(gravest)).substr(0, letters));
    if (text.size() <= width) {
      return text;
    }
  }
  return std::string(name(gravest)).substr(0, width);
}

std::string coloured(const std::string& field, const Checks& checks, bool colour) {
  if (!colour || std::ranges::all_of(checks, isWell)) {
    return field;
  }
  constexpr const char* kRed = "\033[31m";
  constexpr const char* kYellow = "\033[33m";
  return fmt::format("{}{}\033[0m", isFailure(gravestOutcome(checks)) ? kRed : kYellow, field);
}

std::string line(const Row& row, const std::vector<Column>& columns, std::size_t label_width, bool colour) {
  std::string text = fmt::format("  {:<{}}", cellText(row.label, label_width - 2), label_width - 2);
  for (const Column& column : columns) {
    const auto checks = row.by_device.find(column.device);
    const bool is_asked = checks != row.by_device.end();
    const std::string field = is_asked ? fieldText(checks->second, column.width) : "-";
    const std::string padded = fmt::format(" {:>{}}", field, column.width);
    text += is_asked ? coloured(padded, checks->second, colour) : padded;
  }
  return text + "\n";
}

}  // namespace

std::string outcomeTable(std::span<const CellRecord> records, bool colour) {
  const std::vector<Column> columns = columnsOf(records);
  std::size_t taken = 0;
  for (const Column& column : columns) {
    taken += column.width + 1;
  }
  const std::size_t label_width = taken + kShortestLabel < kWidth ? kWidth - taken : kShortestLabel;
  std::string upper(label_width, ' ');
  std::string lower(label_width, ' ');
  for (const Column& column : columns) {
    upper += fmt::format(" {:>{}}", column.upper, column.width);
    lower += fmt::format(" {:>{}}", column.lower, column.width);
  }
  std::string text = upper + "\n" + lower + "\n";
  for (const TestRows& test : rowsOf(records)) {
    text += test.test + "\n";
    for (const Row& whole : test.rows) {
      for (const Row& row : splitByStage(whole)) {
        text += line(row, columns, label_width, colour);
      }
    }
  }
  return text;
}

}  // namespace ssrkit
