// What became of a run's series since an earlier run.
#include <fmt/format.h>

#include <algorithm>

#include "report/bench_report.h"

namespace ssrkit {

namespace {

bool isSameSeries(const BenchSeries& a, const BenchSeries& b) {
  return a.scene == b.scene && a.device == b.device && a.stage == b.stage && a.case_name == b.case_name &&
         a.size == b.size && a.pass == b.pass;
}

const BenchSeries* findSeries(std::span<const BenchSeries> all, const BenchSeries& wanted) {
  const auto found =
      std::ranges::find_if(all, [&](const BenchSeries& series) { return isSameSeries(series, wanted); });
  return found == all.end() ? nullptr : &*found;
}

// Empty where both were traced alike.
std::string otherParameters(const BenchSeries& now, const BenchSeries& then) {
  if (!now.parameters || !then.parameters) {
    return now.parameters || then.parameters ? "one of them traces nothing" : "";
  }
  std::string differences;
  for (const std::string& parameter : parameterNames()) {
    const std::string value = parameterText(*now.parameters, parameter);
    const std::string former = parameterText(*then.parameters, parameter);
    if (value != former) {
      differences +=
          fmt::format("{}{} is {} and was {}", differences.empty() ? "" : ", ", parameter, value, former);
    }
  }
  return differences;
}

BenchUncompared uncompared(BenchSeries series, std::string why) {
  series.steady.clear();
  return {std::move(series), std::move(why)};
}

std::vector<double> cpuTimes(const BenchSeries& series) {
  std::vector<double> values;
  for (const PassTime& time : series.steady) {
    values.push_back(static_cast<double>(time.cpu_ns));
  }
  return values;
}

}  // namespace

BenchComparison compareSeries(const std::vector<BenchSeries>& now, std::span<const BenchSeries> then) {
  BenchComparison comparison;
  for (const BenchSeries& series : now) {
    const BenchSeries* const former = findSeries(then, series);
    const std::string why = former == nullptr ? "only in this run" : otherParameters(series, *former);
    if (!why.empty()) {
      comparison.uncompared.push_back(uncompared(series, why));
      continue;
    }
    const auto ratio = unpairedRatio(cpuTimes(series), cpuTimes(*former));
    comparison.changes.push_back({.series = &series, .ratio = ratio, .move = moveOf(ratio, kBenchMargin)});
  }
  for (const BenchSeries& former : then) {
    if (findSeries(now, former) == nullptr) {
      comparison.uncompared.push_back(uncompared(former, "only in the baseline"));
    }
  }
  return comparison;
}

}  // namespace ssrkit
