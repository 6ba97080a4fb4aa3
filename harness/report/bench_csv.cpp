// DIR/bench.csv: one line a series, for spreadsheets and plots of one's own.
#include <fmt/format.h>

#include <algorithm>

#include "report/bench_report.h"
#include "report/milliseconds.h"

namespace ssrkit {

namespace {

// Scenes may be anybody's files: quoted where the name would break the line (RFC 4180).
std::string csvText(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) {
    return text;
  }
  std::string quoted = "\"";
  for (const char byte : text) {
    quoted += byte == '"' ? "\"\"" : std::string(1, byte);
  }
  return quoted + "\"";
}

// Where every round has one.
std::string deviceMs(const BenchSeries& series) {
  std::vector<PassTime> times = series.steady;
  const bool all_have =
      std::ranges::all_of(times, [](const PassTime& time) { return time.device_ns.has_value(); });
  if (!all_have || times.empty()) {
    return "";
  }
  for (PassTime& time : times) {
    time.wall_ns = *time.device_ns;
  }
  return fmt::format("{:.6g}", medianNs(times, &PassTime::wall_ns) * kMsPerNs);
}

}  // namespace

std::string benchCsv(const BenchReport& report) {
  std::string text =
      "scene,device,width,height,stage,case,pass,rays,lookups,rounds,cpu_ms,cpu_ms_low,cpu_ms_high,wall_ms,"
      "device_ms,first_cpu_ms,first_wall_ms\n";
  for (const BenchSeries& series : report.series) {
    const auto interval = cpuMsInterval(series);
    text += fmt::format("{},{},{},{},{},{},{},{},{:.0f},{},{:.6g},{},{:.6g},{},{:.6g},{:.6g}\n",
                        csvText(series.scene), csvText(series.device), series.size.width, series.size.height,
                        csvText(series.stage), csvText(series.case_name), csvText(series.pass), series.rays,
                        series.lookups, series.steady.size(),
                        medianNs(series.steady, &PassTime::cpu_ns) * kMsPerNs,
                        interval ? fmt::format("{:.6g},{:.6g}", interval->low, interval->high) : ",",
                        medianNs(series.steady, &PassTime::wall_ns) * kMsPerNs, deviceMs(series),
                        static_cast<double>(series.first.cpu_ns) * kMsPerNs,
                        static_cast<double>(series.first.wall_ns) * kMsPerNs);
  }
  return text;
}

}  // namespace ssrkit
