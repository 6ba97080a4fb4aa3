// DIR/report.html: the claims with their figures as bars, in one file that needs no network.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/claims_report.h"
#include "report/claims_svg.h"
#include "report/html_text.h"
#include "report/pass_table.h"

namespace ssrkit {

namespace {

constexpr const char* kClaimsStyle = R"(
body { font: 16px/1.45 system-ui, sans-serif; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; color: #1a1a1a; }
h2 { margin: 3rem 0 .5rem; border-top: 1px solid #ccc; padding-top: 1.5rem; }
code, pre, td, th { font-family: ui-monospace, monospace; font-size: .85rem; }
pre { background: #f4f4f4; padding: .7rem; overflow-x: auto; }
table { border-collapse: collapse; } td, th { text-align: left; padding: .15rem .8rem .15rem 0; vertical-align: top; }
.verdict { padding: .1rem .5rem; border-radius: .3rem; font-size: 1rem; font-weight: 600; color: #000; }
.confirmed { background: #8fd9c0; } .refuted { background: #f3a97f; } .inconclusive { background: #f0e442; }
.unknown { background: #e3b5cd; }
dt { font-weight: 600; margin-top: .4rem; } dd { margin: 0; }
svg { max-width: 100%; height: auto; margin: .8rem 0; } svg text { font: 12px ui-monospace, monospace; fill: #1a1a1a; }
.quiet { color: #555; }
)";

const char* classOf(ClaimVerdict verdict) {
  return verdict == ClaimVerdict::kNotMeasured ? "unknown" : name(verdict);
}

std::string badge(ClaimVerdict verdict) {
  return fmt::format("<span class=\"verdict {}\">{}</span>", classOf(verdict), name(verdict));
}

std::string remarksOf(const ClaimReport& report) {
  std::string rows;
  for (const ClaimFigure& figure : report.result.figures) {
    const CheckResult& check = figure.check;
    if (!check.remark.empty()) {
      rows +=
          fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", htmlText(fullName(check)), htmlText(check.remark));
    }
  }
  return rows.empty()
             ? ""
             : fmt::format(
                   "<details><summary>What each figure is made of</summary><table>{}</table></details>\n",
                   rows);
}

std::string sectionOf(const ClaimReport& report) {
  const Claim& claim = report.claim;
  std::string text =
      fmt::format("<h2 id=\"{0}\">{0} {1}</h2>\n", htmlText(claim.name), badge(report.result.verdict));
  text += fmt::format(
      "<dl><dt>Claim</dt><dd>{} <span class=\"quiet\">({})</span></dd>\n<dt>Hypothesis</dt><dd>{}</dd>\n"
      "<dt>Verdict</dt><dd>{}</dd></dl>\n",
      htmlText(claim.says), htmlText(claim.source), htmlText(claim.test.about),
      htmlText(verdictText(report)));
  for (const std::string& drawing : figureDrawings(report)) {
    text += drawing;
  }
  if (const std::string passes = passTable(report.frames, report.rows); !passes.empty()) {
    text += fmt::format("<pre>{}</pre>\n", htmlText(passes));
  }
  return text + remarksOf(report) + fmt::format("<pre>{}</pre>\n", htmlText(report.again));
}

std::string overviewOf(const ClaimsReport& report) {
  std::string rows;
  for (const ClaimReport& claim : report.claims) {
    rows += fmt::format("<tr><td><a href=\"#{0}\">{0}</a></td><td>{1}</td><td>{2}</td></tr>\n",
                        htmlText(claim.claim.name), badge(claim.result.verdict), htmlText(claim.claim.says));
  }
  return fmt::format("<table>{}</table>\n", rows);
}

}  // namespace

std::string claimsHtml(const ClaimsReport& report) {
  std::string text = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width\">\n<title>Claims about screen-space "
      "reflections</title><style>{}</style></head>\n"
      "<body><h1>Claims about screen-space reflections</h1>\n<p>{}: {}.</p>\n",
      kClaimsStyle, htmlText(report.started), htmlText(verdictCounts(report)));
  for (const DeviceRow& device : report.devices) {
    text += fmt::format("<p class=\"quiet\">{}: {} {}</p>\n", htmlText(device.identity.id),
                        htmlText(device.identity.driver), htmlText(device.identity.version));
  }
  text += overviewOf(report);
  for (const ClaimReport& claim : report.claims) {
    text += sectionOf(claim);
  }
  return text + "</body></html>\n";
}

}  // namespace ssrkit
