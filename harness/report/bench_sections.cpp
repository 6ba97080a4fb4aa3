#include "report/bench_sections.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/size.h"
#include "report/milliseconds.h"
#include "report/table_text.h"

namespace ssrkit {

namespace {

std::string lawText(const std::optional<PowerLaw>& law) {
  return law ? fmt::format("{:.2f} +- {:.2f}", law->exponent, law->standard_error) : "-";
}

// Of the rays that have one.
std::string shareText(const BenchAnswer& answer, std::initializer_list<Verdict> verdicts) {
  std::size_t count = 0;
  for (const Verdict verdict : verdicts) {
    count += answer.verdicts.at(static_cast<std::size_t>(verdict));
  }
  const double all = std::max(1.0, static_cast<double>(answer.rays));
  return fmt::format("{:.2f}", 100.0 * static_cast<double>(count) / all);
}

std::string seriesPlace(const BenchSeries& series) {
  return fmt::format("{} {} {} {} {}", series.scene, sizeText(series.size), series.device, series.stage,
                     series.pass);
}

std::string replacementsText(const std::vector<std::string>& replacements) {
  return replacements.empty() ? "none" : cellText(fmt::format("{}", fmt::join(replacements, " ")), 74);
}

}  // namespace

std::string intervalText(const std::optional<RatioInterval>& interval) {
  return interval ? fmt::format("{} .. {}", measureText(interval->low), measureText(interval->high)) : "-";
}

std::string msText(double ns) {
  return ns > 0.0 ? measureText(ns * kMsPerNs) : "-";
}

std::string nativesText(const BenchReport& report) {
  std::string text =
      report.over_natives.empty() ? "" : "traces over the same rays by the CPU's own vectors, CPU time\n";
  for (const BenchNativeRatio& over : report.over_natives) {
    const BenchSeries& series = *over.series;
    text +=
        fmt::format("  {:<58}{:<16}{:>7}{:>17}\n",
                    cellText(fmt::format("{} {}x{} {} {} {}", series.scene, series.size.width,
                                         series.size.height, series.device, series.stage, series.case_name),
                             57),
                    over.peer, over.ratio ? measureText(over.ratio->median) : "-", intervalText(over.ratio));
  }
  return text.empty() ? text : text + "\n";
}

std::string answersText(const BenchReport& report) {
  std::string text;
  for (const BenchAnswer& answer : report.answers) {
    if (text.empty()) {
      text = fmt::format(
          "answers against the exact walk, % of the rays, ties as the same\n  "
          "{:<26}{:<15}{:>7}{:>6}{:>7}{:>7}{:>7}{:>22}\n",
          "scene and device", "stage", "same", "near", "wrong", "false", "missed", "lookups, p95, most");
    }
    const bool has_lookups = answer.lookups_per_ray > 0.0;
    text += fmt::format(
        "  {:<26}{:<15}{:>7}{:>6}{:>7}{:>7}{:>7}{:>8}{:>7}{:>7}\n",
        cellText(answer.scene + " " + answer.device, 25), cellText(answer.stage, 14),
        shareText(answer, {Verdict::kSame, Verdict::kAmbiguous}), shareText(answer, {Verdict::kNear}),
        shareText(answer, {Verdict::kWrong, Verdict::kLeak}), shareText(answer, {Verdict::kFalseHit}),
        shareText(answer, {Verdict::kMissedHit}), has_lookups ? measureText(answer.lookups_per_ray) : "-",
        has_lookups ? measureText(answer.p95_lookups) : "-",
        has_lookups ? measureText(answer.max_lookups) : "-");
  }
  return text.empty() ? text : text + "\n";
}

std::string startsText(const BenchReport& report) {
  if (report.starts.empty()) {
    return "";
  }
  std::string text = fmt::format(
      "before a steady frame, wall ms of a fresh process\n  {:<20}{:<20}{:<9}{:>9}{:>9}{:>10}{:>13}\n",
      "device", "scene", "caches", "context", "compile", "pipeline", "first draws");
  for (const BenchStart& start : report.starts) {
    text += fmt::format(
        "  {:<20}{:<20}{:<9}{:>9}{:>9}{:>10}{:>13}\n", cellText(start.device, 19), cellText(start.scene, 19),
        start.has_caches ? "warm" : "cold", msText(static_cast<double>(start.create_ns)),
        msText(static_cast<double>(start.compile_ns)), msText(static_cast<double>(start.pipeline_ns)),
        msText(static_cast<double>(start.first_ns)));
  }
  return text + "\n";
}

std::string scalingText(const BenchReport& report) {
  std::string text;
  const BenchScaling* previous = nullptr;
  for (const BenchScaling& scaling : report.scalings) {
    if (previous == nullptr || previous->axis != scaling.axis || previous->clock != scaling.clock) {
      text += fmt::format("{} ({}): exponent and its standard error\n  {:<16}{:<22}{:<16}{:>18}{:>18}\n",
                          scaling.axis, scaling.x_unit, "scene", "device", "stage", scaling.clock + " ns/ray",
                          "lookups/ray");
    }
    previous = &scaling;
    text += fmt::format("  {:<16}{:<22}{:<16}{:>18}{:>18}\n", cellText(scaling.scene, 15),
                        cellText(scaling.device, 21), cellText(scaling.stage, 15), lawText(scaling.time),
                        lawText(scaling.lookups));
    for (const BenchScalingPoint& point : scaling.points) {
      text += fmt::format("    {:<50}{:>20}{:>18}\n", cellText(point.label, 49),
                          measureText(point.ns_per_ray), measureText(point.lookups_per_ray));
    }
  }
  return text.empty() ? text : text + "\n";
}

std::string changesText(const BenchReport& report) {
  if (report.baseline.empty()) {
    return "";
  }
  std::string text = fmt::format("against {}, CPU time now over then\n", report.baseline);
  if (report.replacements != report.baseline_replacements) {
    text += fmt::format("  shaders replaced now:  {}\n", replacementsText(report.replacements));
    text += fmt::format("  shaders replaced then: {}\n", replacementsText(report.baseline_replacements));
  }
  std::size_t unchanged = 0;
  for (const BenchChange& change : report.comparison.changes) {
    if (change.move == BenchMove::kUnchanged) {
      ++unchanged;
      continue;
    }
    const BenchSeries& series = *change.series;
    text += fmt::format("  {:<13}{:>7}{:>17}  {}\n", name(change.move),
                        change.ratio ? measureText(change.ratio->median) : "-", intervalText(change.ratio),
                        cellText(seriesPlace(series), 58));
  }
  for (const BenchUncompared& one : report.comparison.uncompared) {
    text += fmt::format("  {:<14}{:<50}{}\n", "not compared", cellText(seriesPlace(one.series), 49),
                        cellText(one.why, 34));
  }
  return text + fmt::format("  {} of {} passes unchanged within {:.0f} %\n\n", unchanged,
                            report.comparison.changes.size(), 100.0 * kBenchMargin);
}

std::string gatesText(const BenchReport& report) {
  std::string text = report.gates.empty() ? "" : "gates\n";
  for (const CheckResult& gate : report.gates) {
    const std::string figure =
        gate.value ? measureText(*gate.value) +
                         (gate.interval ? fmt::format(" ({} .. {})", measureText(gate.interval->first),
                                                      measureText(gate.interval->second))
                                        : "")
                   : "-";
    text += fmt::format("  {:<13}{}\n", name(gate.outcome), cellText(fullName(gate), 84));
    text += fmt::format("  {:<13}{:<24}{}\n", "", figure, cellText(boundText(gate), 60));
  }
  return text.empty() ? text : text + "\n";
}

}  // namespace ssrkit
