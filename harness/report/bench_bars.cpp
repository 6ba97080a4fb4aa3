#include <fmt/format.h>

#include <algorithm>

#include "report/bench_svg.h"
#include "report/drawing_width.h"
#include "report/html_text.h"
#include "report/milliseconds.h"
#include "report/table_text.h"

namespace ssrkit {

namespace {

constexpr double kPassLabelWidth = 300.0;
constexpr double kPassBarWidth = 480.0;
constexpr double kPassRowHeight = 20.0;
constexpr double kPassHeaderHeight = 26.0;
constexpr const char* kTrace = "#0072b2";  // Okabe and Ito's colours, as in every picture of the kit
constexpr const char* kOther = "#56b4e9";
constexpr const char* kRoofline = "#e69f00";

const char* passColour(const BenchSeries& series) {
  return series.pass == "trace" ? kTrace : series.pass.starts_with("bench_") ? kRoofline : kOther;
}

std::string passBar(const BenchSeries& series, double y, double scale_ms) {
  const double median = medianNs(series.steady, &PassTime::cpu_ns) * kMsPerNs;
  const auto x = [&](double ms) {
    return kPassLabelWidth + kPassBarWidth * std::clamp(ms / scale_ms, 0.0, 1.0);
  };
  const std::string label =
      series.stage.empty() ? series.pass : series.stage + " " + series.case_name + " " + series.pass;
  std::string text = fmt::format(
      "<text x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text><rect x=\"{}\" y=\"{}\" width=\"{:.1f}\" "
      "height=\"13\" "
      "fill=\"{}\"/>",
      kPassLabelWidth - 8, y + 13, htmlText(label), kPassLabelWidth, y + 2,
      std::max(1.0, x(median) - kPassLabelWidth), passColour(series));
  if (const auto interval = cpuMsInterval(series)) {
    text +=
        fmt::format("<path d=\"M{:.1f} {}V{}M{:.1f} {}H{:.1f}M{:.1f} {}V{}\" stroke=\"#000\" fill=\"none\"/>",
                    x(interval->low), y + 5, y + 12, x(interval->low), y + 8.5, x(interval->high),
                    x(interval->high), y + 5, y + 12);
  }
  return text + fmt::format("<text x=\"{}\" y=\"{}\">{} ms</text>\n", kPassLabelWidth + kPassBarWidth + 10,
                            y + 13, measureText(median));
}

std::string passesDrawing(const std::vector<const BenchSeries*>& group) {
  double scale_ms = 0.0;
  for (const BenchSeries* series : group) {
    const auto interval = cpuMsInterval(*series);
    scale_ms = std::max(scale_ms,
                        interval ? interval->high : medianNs(series->steady, &PassTime::cpu_ns) * kMsPerNs);
  }
  scale_ms = scale_ms > 0.0 ? scale_ms * 1.02 : 1.0;
  const BenchSeries& first = *group.front();
  std::string text = fmt::format(
      "<text x=\"0\" y=\"15\" font-weight=\"bold\">{}</text>\n",
      htmlText(fmt::format("{} {}x{} on {}: CPU time, median of {} rounds", first.scene, first.size.width,
                           first.size.height, first.device, first.steady.size())));
  double y = kPassHeaderHeight;
  for (const BenchSeries* series : group) {
    text += passBar(*series, y, scale_ms);
    y += kPassRowHeight;
  }
  return fmt::format("<svg viewBox=\"0 0 {} {}\" width=\"{}\" role=\"img\">{}</svg>\n", kDrawingWidth, y + 4,
                     kDrawingWidth, text);
}

}  // namespace

std::vector<std::string> benchBars(const BenchReport& report) {
  std::vector<std::vector<const BenchSeries*>> groups;
  for (const BenchSeries& series : report.series) {
    const auto group = std::ranges::find_if(groups, [&](const std::vector<const BenchSeries*>& known) {
      const BenchSeries& first = *known.front();
      return first.scene == series.scene && first.device == series.device && first.size == series.size;
    });
    if (group == groups.end()) {
      groups.push_back({&series});
    } else {
      group->push_back(&series);
    }
  }
  std::vector<std::string> drawings;
  std::ranges::transform(groups, std::back_inserter(drawings), passesDrawing);
  return drawings;
}

}  // namespace ssrkit
