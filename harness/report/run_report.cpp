#include "report/run_report.h"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "base/check.h"
#include "check/percentile.h"
#include "report/milliseconds.h"

namespace ssrkit {

namespace {

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

double medianOrCold_ms(const PassReport& pass, std::int64_t PassTime::*field) {
  if (pass.steady.empty()) {
    return kMsPerNs * static_cast<double>(pass.cold.*field);
  }
  std::vector<double> times;
  for (const PassTime& time : pass.steady) {
    times.push_back(kMsPerNs * static_cast<double>(time.*field));
  }
  return median(std::move(times));
}

}  // namespace

TraceSummary summarise(const RayRecord& record, std::span<const Verdict> verdicts) {
  TraceSummary summary;
  std::vector<double> lookups;
  lookups.reserve(record.rays.size());  // what is not filled takes no memory
  for (const RayHit& ray : record.rays) {
    if (isKnown(ray.ray_class)) {
      ++summary.classes.at(static_cast<std::size_t>(ray.ray_class));
    }
    if (!hasNoRay(ray.ray_class)) {
      lookups.push_back(ray.lookups);
    }
  }
  summary.traced_rays = lookups.size();
  if (!lookups.empty()) {
    const double total = std::accumulate(lookups.begin(), lookups.end(), 0.0);
    summary.lookups = {total / static_cast<double>(lookups.size()), percentileAmong(lookups, 50),
                       percentileAmong(lookups, 95), std::ranges::max(lookups)};
  }
  if (!verdicts.empty()) {
    SSRKIT_CHECK_EQ(verdicts.size(), record.rays.size());
    summary.verdicts = countVerdicts(verdicts);
  }
  return summary;
}

TrueClassSummary summarise(const GeometryResult& geometry, std::span<const GeometryVerdict> against_geometry,
                           std::span<const Verdict> against_oracle) {
  SSRKIT_CHECK_EQ(geometry.pixelCount(), against_oracle.size());
  TrueClassSummary summary{.geometry = countByTrueClass(geometry, against_geometry), .against_oracle = {}};
  for (std::size_t i = 0; i < against_oracle.size(); ++i) {
    const auto true_class = static_cast<std::size_t>(geometry.at(i).true_class);
    ++summary.against_oracle.at(true_class).at(static_cast<std::size_t>(against_oracle[i]));
  }
  return summary;
}

std::optional<TraceCost> traceCost(std::span<const PassReport> passes) {
  std::optional<TraceCost> cost;
  for (const PassReport& pass : passes) {
    if (pass.pass.starts_with("trace") || pass.pass.starts_with("pyramid")) {
      cost = cost.value_or(TraceCost{});
      cost->cpu_ms += medianOrCold_ms(pass, &PassTime::cpu_ns);
      cost->wall_ms += medianOrCold_ms(pass, &PassTime::wall_ns);
    }
  }
  return cost;
}

double cpuMs(const PassReport& pass) {
  return medianOrCold_ms(pass, &PassTime::cpu_ns);
}

std::optional<double> sameFraction(const VerdictCounts& verdicts) {
  const std::size_t all = std::accumulate(verdicts.begin(), verdicts.end(), std::size_t{0});
  const std::size_t compared = all - verdicts.at(static_cast<std::size_t>(Verdict::kNone));
  if (compared == 0) {
    return std::nullopt;
  }
  return static_cast<double>(verdicts.at(static_cast<std::size_t>(Verdict::kSame))) /
         static_cast<double>(compared);
}

std::vector<Outcome> outcomesOf(const RunReport& report) {
  const UnitTestCounts unit = report.unit_tests.value_or(UnitTestCounts{});
  std::vector<Outcome> outcomes(unit.passed, Outcome::kPass);
  outcomes.insert(outcomes.end(), unit.failed, Outcome::kFail);
  outcomes.insert(outcomes.end(), unit.skipped, Outcome::kSkip);
  std::ranges::transform(report.checks, std::back_inserter(outcomes), &CheckResult::outcome);
  return outcomes;
}

}  // namespace ssrkit
