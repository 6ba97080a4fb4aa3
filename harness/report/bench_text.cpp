#include <fmt/format.h>

#include <algorithm>

#include "report/bench_report.h"
#include "report/bench_sections.h"
#include "report/table_text.h"

namespace ssrkit {

namespace {

// What stands together in one table.
bool isSameGroup(const BenchSeries& a, const BenchSeries& b) {
  return a.scene == b.scene && a.device == b.device && a.size == b.size;
}

std::string traceLabel(const BenchSeries& series) {
  return series.case_name.empty() ? series.stage : series.stage + " " + series.case_name;
}

// Of rounds in which the API's timestamps were read, all of them or none.
std::string deviceText(const BenchSeries& series) {
  const auto& steady = series.steady;
  if (steady.empty() ||
      !std::ranges::all_of(steady, [](const PassTime& time) { return time.device_ns.has_value(); })) {
    return "-";
  }
  std::vector<PassTime> times = steady;
  for (PassTime& time : times) {
    time.wall_ns = *time.device_ns;
  }
  return msText(medianNs(times, &PassTime::wall_ns));
}

std::string seriesLine(const BenchSeries& series, std::span<const BenchSeries> all) {
  const double cpu_ns = medianNs(series.steady, &PassTime::cpu_ns);
  const auto multiple = series.pass == "trace" ? rooflineMultiple(series, all) : std::nullopt;
  return fmt::format("  {:<14}{:<22}{:>7}{:>16}{:>8}{:>7}{:>8}{:>8}{:>8}\n", cellText(traceLabel(series), 13),
                     cellText(series.pass, 21), msText(cpu_ns), intervalText(cpuMsInterval(series)),
                     msText(medianNs(series.steady, &PassTime::wall_ns)), deviceText(series),
                     msText(static_cast<double>(series.first.cpu_ns)),
                     series.rays > 0 ? measureText(cpu_ns / static_cast<double>(series.rays)) : "-",
                     multiple ? measureText(multiple->median) : "-");
}

// Each trace against the first stage's, which is hiz where hiz was run.
std::string ratiosOf(const std::vector<const BenchSeries*>& group) {
  std::vector<const BenchSeries*> traces;
  std::ranges::copy_if(group, std::back_inserter(traces),
                       [](const BenchSeries* series) { return series->pass == "trace"; });
  if (traces.size() < 2) {
    return "";
  }
  const auto hiz =
      std::ranges::find_if(traces, [](const BenchSeries* trace) { return trace->stage == "hiz"; });
  const BenchSeries& over = hiz == traces.end() ? *traces.front() : **hiz;
  std::string text;
  for (const BenchSeries* trace : traces) {
    if (trace == &over) {
      continue;
    }
    const auto ratio = cpuRatio(*trace, over);
    const bool is_settled = ratio && ratio->high <= ratio->low * (1.0 + 2.0 * kBenchMargin);
    text += fmt::format("  {:<34}{:>7}{:>17}  {}\n",
                        cellText(traceLabel(*trace) + " over " + traceLabel(over), 33),
                        ratio ? measureText(ratio->median) : "-", intervalText(ratio),
                        is_settled ? "" : "inconclusive: wider than 10 %");
  }
  return "  trace, ratios of CPU time round by round\n" + text;
}

std::string seriesGroupText(const std::vector<const BenchSeries*>& group, std::span<const BenchSeries> all) {
  const BenchSeries& first = *group.front();
  std::string text =
      fmt::format("{} {}x{} {}: ms in the median of {} rounds, 99 % interval of CPU time\n", first.scene,
                  first.size.width, first.size.height, first.device, first.steady.size());
  text += fmt::format("  {:<14}{:<22}{:>7}{:>16}{:>8}{:>7}{:>8}{:>8}{:>8}\n", "stage", "pass", "CPU",
                      "interval", "wall", "device", "first", "ns/ray", "x limit");
  for (const BenchSeries* series : group) {
    text += seriesLine(*series, all);
  }
  return text + ratiosOf(group) + "\n";
}

std::string seriesText(const BenchReport& report) {
  std::string text;
  std::vector<const BenchSeries*> told;
  for (const BenchSeries& series : report.series) {
    const bool is_told =
        std::ranges::any_of(told, [&](const BenchSeries* one) { return isSameGroup(*one, series); });
    if (is_told) {
      continue;
    }
    told.push_back(&series);
    std::vector<const BenchSeries*> group;
    for (const BenchSeries& other : report.series) {
      if (isSameGroup(series, other)) {
        group.push_back(&other);
      }
    }
    text += seriesGroupText(group, report.series);
  }
  return text;
}

}  // namespace

std::string benchText(const BenchReport& report) {
  return seriesText(report) + nativesText(report) + answersText(report) + startsText(report) +
         scalingText(report) + changesText(report) + gatesText(report);
}

}  // namespace ssrkit
