// DIR/bench.html: bars, plots and the text, in one file that needs no network.
#include <fmt/format.h>

#include "report/bench_report.h"
#include "report/bench_svg.h"
#include "report/html_text.h"

namespace ssrkit {

namespace {

constexpr const char* kBenchStyle = R"(
body { font: 16px/1.45 system-ui, sans-serif; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; color: #1a1a1a; }
pre { font-family: ui-monospace, monospace; font-size: .8rem; background: #f4f4f4; padding: .7rem; overflow-x: auto; }
svg { max-width: 100%; height: auto; margin: .8rem 0; } svg text { font-family: ui-monospace, monospace; font-size: 12px; fill: #1a1a1a; }
.quiet { color: #555; }
)";

}  // namespace

std::string benchHtml(const BenchReport& report) {
  std::string text = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width\">\n<title>What screen-space reflections "
      "cost</title><style>{}</style></head>\n"
      "<body><h1>What screen-space reflections cost</h1>\n<p class=\"quiet\">{}, {} cores, {}</p>\n",
      kBenchStyle, htmlText(report.machine.cpu), report.machine.core_count, htmlText(report.started));
  for (const DeviceRow& device : report.devices) {
    text += fmt::format("<p class=\"quiet\">{}: {} {}</p>\n", htmlText(device.identity.id),
                        htmlText(device.identity.driver), htmlText(device.identity.version));
  }
  for (const std::string& drawing : benchPlots(report)) {
    text += drawing;
  }
  for (const std::string& drawing : benchBars(report)) {
    text += drawing;
  }
  text += fmt::format("<h2>Figures</h2>\n<pre>{}</pre>\n<pre>{}</pre>\n", htmlText(benchText(report)),
                      htmlText(fmt::format("{}", fmt::join(report.command, " "))));
  return text + "</body></html>\n";
}

}  // namespace ssrkit
