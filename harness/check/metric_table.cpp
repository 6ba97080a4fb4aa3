#include "check/metric_table.h"

#include <algorithm>

#include "base/check.h"
#include "check/metric_rows.h"

namespace ssrkit {

namespace {

std::vector<MetricRow> makeRows() {
  std::vector<MetricRow> rows = metricsAgainstTruth();
  for (const auto& more : {metricsAgainstGeometry(), metricsOfCost(), metricsOfProperties()}) {
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

}  // namespace

std::span<const MetricRow> metricRows() {
  static const std::vector<MetricRow> rows = makeRows();
  return rows;
}

const MetricRow& row(Metric metric) {
  const auto found = std::ranges::find(metricRows(), metric, &MetricRow::metric);
  SSRKIT_CHECK(found != metricRows().end());
  return *found;
}

const MetricRow* findMetric(std::string_view metric_name) {
  const auto found = std::ranges::find(metricRows(), metric_name, &MetricRow::name);
  return found == metricRows().end() ? nullptr : &*found;
}

std::span<const std::string> metricNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> collected;
    for (const MetricRow& metric_row : metricRows()) {
      collected.push_back(metric_row.name);
    }
    return collected;
  }();
  return names;
}

bool takesKey(const MetricRow& row, std::string_view key) {
  return std::ranges::find(row.keys, key) != row.keys.end();
}

bool needsKey(const MetricRow& row, std::string_view key) {
  return std::ranges::find(row.needed_keys, key) != row.needed_keys.end();
}

}  // namespace ssrkit
