// The rows of the metric table, by what they look at.
#pragma once

#include <vector>

#include "check/measure.h"
#include "check/metric_table.h"

namespace ssrkit {

[[nodiscard]] std::vector<MetricRow> metricsAgainstTruth();
[[nodiscard]] std::vector<MetricRow> metricsAgainstGeometry();
[[nodiscard]] std::vector<MetricRow> metricsOfCost();
[[nodiscard]] std::vector<MetricRow> metricsOfProperties();

// For a metric that asks nothing of the expectation.
template <Measurement (*measure_subject)(const Subject&)>
Measurement bySubject(const Expectation&, const Subject& subject) {
  return measure_subject(subject);
}

}  // namespace ssrkit
