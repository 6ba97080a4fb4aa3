#include <algorithm>

#include "check/percentile.h"
#include "report/bench_report.h"
#include "report/milliseconds.h"
#include "spaces/roofline.h"

namespace ssrkit {

namespace {

BenchSeries passSeries(const PassReport& report) {
  BenchSeries series;
  series.pass = report.pass;
  series.first = report.cold;
  series.steady = report.steady;
  return series;
}

std::vector<double> clockOf(std::span<const PassTime> times, std::int64_t PassTime::*clock) {
  std::vector<double> values;
  for (const PassTime& time : times) {
    values.push_back(static_cast<double>(time.*clock));
  }
  return values;
}

// The series of another pass of the same trace.
const BenchSeries* sisterOf(const BenchSeries& trace, std::string_view pass,
                            std::span<const BenchSeries> all) {
  const auto found = std::ranges::find_if(all, [&](const BenchSeries& other) {
    return other.scene == trace.scene && other.device == trace.device && other.stage == trace.stage &&
           other.case_name == trace.case_name && other.size == trace.size && other.pass == pass;
  });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

const char* name(BenchMove move) {
  switch (move) {
    case BenchMove::kUnchanged:
      return "unchanged";
    case BenchMove::kFaster:
      return "faster";
    case BenchMove::kSlower:
      return "slower";
    case BenchMove::kInconclusive:
      break;
  }
  return "inconclusive";
}

std::vector<BenchSeries> benchSeries(std::span<const FrameRow> frames, std::span<const RunRow> rows) {
  std::vector<BenchSeries> all;
  for (const FrameRow& frame : frames) {
    for (const PassReport& report : frame.passes) {
      BenchSeries series = passSeries(report);
      series.scene = frame.scene;
      series.device = frame.device;
      series.size = frame.size;
      all.push_back(std::move(series));
    }
  }
  for (const RunRow& row : rows) {
    for (const PassReport& report : row.passes) {
      BenchSeries series = passSeries(report);
      series.scene = row.scene;
      series.device = row.device;
      series.stage = row.stage;
      series.case_name = row.case_name;
      series.size = row.size;
      series.parameters = row.parameters;
      if (row.summary) {
        series.rays = row.summary->traced_rays;
        series.lookups = row.summary->lookups.mean * static_cast<double>(row.summary->traced_rays);
      }
      all.push_back(std::move(series));
    }
  }
  return all;
}

std::vector<BenchAnswer> benchAnswers(std::span<const RunRow> rows) {
  std::vector<BenchAnswer> answers;
  for (const RunRow& row : rows) {
    if (!row.summary || !row.summary->verdicts) {
      continue;
    }
    const TraceSummary& summary = *row.summary;
    const VerdictCounts& verdicts = *summary.verdicts;
    const auto count = [&verdicts](Verdict verdict) {
      return verdicts.at(static_cast<std::size_t>(verdict));
    };
    BenchAnswer answer{.scene = row.scene,
                       .device = row.device,
                       .stage = row.stage,
                       .case_name = row.case_name,
                       .size = row.size,
                       .rays = summary.traced_rays,
                       .verdicts = verdicts,
                       .lookups_per_ray = summary.lookups.mean,
                       .p95_lookups = summary.lookups.p95,
                       .max_lookups = summary.lookups.max};
    // A tie may be either.
    answer.mask_errors = count(Verdict::kFalseHit) + count(Verdict::kMissedHit);
    answers.push_back(std::move(answer));
  }
  return answers;
}

std::optional<RatioInterval> cpuMsInterval(const BenchSeries& series) {
  std::vector<double> values = clockOf(series.steady, &PassTime::cpu_ns);
  for (double& value : values) {
    value *= kMsPerNs;
  }
  return medianInterval(values);
}

double medianNs(std::span<const PassTime> times, std::int64_t PassTime::*clock) {
  constexpr double kMedian = 50.0;
  return times.empty() ? 0.0 : percentileOf(clockOf(times, clock), kMedian);
}

std::optional<RatioInterval> cpuRatio(const BenchSeries& series, const BenchSeries& other) {
  if (series.steady.size() != other.steady.size()) {
    return std::nullopt;
  }
  return pairedRatio(clockOf(series.steady, &PassTime::cpu_ns), clockOf(other.steady, &PassTime::cpu_ns));
}

std::vector<BenchNativeRatio> ratiosOverNatives(const std::vector<BenchSeries>& series,
                                                std::span<const std::string> natives) {
  std::vector<BenchNativeRatio> ratios;
  for (const BenchSeries& trace : series) {
    const bool is_native = std::ranges::find(natives, trace.device) != natives.end();
    for (const std::string& peer : is_native ? std::span<const std::string>{} : natives) {
      BenchSeries sought = trace;
      sought.device = peer;
      const BenchSeries* const made = sisterOf(sought, "trace", series);
      if (trace.pass == "trace" && made != nullptr) {
        ratios.push_back({&trace, peer, cpuRatio(trace, *made)});
      }
    }
  }
  return ratios;
}

std::optional<RatioInterval> rooflineMultiple(const BenchSeries& trace, std::span<const BenchSeries> all) {
  const BenchSeries* const fetches = sisterOf(trace, "bench_dependent_fetch", all);
  const BenchSeries* const writes = sisterOf(trace, "bench_write", all);
  if (fetches == nullptr || writes == nullptr || fetches->steady.size() != trace.steady.size() ||
      writes->steady.size() != trace.steady.size()) {
    return std::nullopt;
  }
  const double pixels = static_cast<double>(trace.size.width) * static_cast<double>(trace.size.height);
  const double share = trace.lookups / (kRooflineFetchCount * pixels);
  std::vector<double> limits;
  for (std::size_t round = 0; round < trace.steady.size(); ++round) {
    limits.push_back(share * static_cast<double>(fetches->steady[round].cpu_ns) +
                     static_cast<double>(writes->steady[round].cpu_ns));
  }
  return pairedRatio(clockOf(trace.steady, &PassTime::cpu_ns), limits);
}

BenchMove moveOf(const std::optional<RatioInterval>& ratio, double margin) {
  if (!ratio) {
    return BenchMove::kInconclusive;
  }
  if (ratio->low > 1.0 + margin) {
    return BenchMove::kSlower;
  }
  if (ratio->high < 1.0 / (1.0 + margin)) {
    return BenchMove::kFaster;
  }
  const bool is_within = ratio->low >= 1.0 / (1.0 + margin) && ratio->high <= 1.0 + margin;
  return is_within ? BenchMove::kUnchanged : BenchMove::kInconclusive;
}

}  // namespace ssrkit
