#include "report/checks_html.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <unordered_map>

#include "base/json_text.h"
#include "base/size.h"
#include "check/outcome.h"
#include "report/checks_page.h"
#include "report/finding_picture.h"
#include "report/html_text.h"
#include "report/json_parts.h"
#include "report/ledger_table.h"
#include "report/plain_utf8.h"

namespace ssrkit {

namespace {

// From the most harmless to the worst: the matrix shows the worst of a cell.
constexpr std::array<Outcome, kOutcomeCount> kWorstLast = {
    Outcome::kPass,         Outcome::kSkip,    Outcome::kXfail, Outcome::kWarn, Outcome::kFlake,
    Outcome::kInconclusive, Outcome::kLimiter, Outcome::kXpass, Outcome::kFail, Outcome::kMissing,
    Outcome::kError,        Outcome::kTimeout, Outcome::kCrash};

// A page of pictures for every failure of a broken driver would be too large to open.
constexpr std::size_t kMostPictures = 60;

// Every different text once: ids, scenes and commands repeat thousands of times.
class TextTable {
 public:
  std::size_t add(const std::string& text) {
    const auto [entry, is_new] = numbers_.try_emplace(text, texts_.size());
    if (is_new) {
      texts_.push_back(plainUtf8(text));
    }
    return entry->second;
  }
  [[nodiscard]] const std::vector<std::string>& texts() const { return texts_; }

 private:
  std::unordered_map<std::string, std::size_t> numbers_;
  std::vector<std::string> texts_;
};

std::string valueWithUnit(const CheckResult& check) {
  return check.value ? fmt::format("{:.6g} {}", *check.value, check.unit) : "";
}

Expected<Json> rowsOf(const RunReport& report, TextTable& texts) {
  Json rows = Json::array();
  std::size_t picture_count = 0;
  for (const CheckResult& check : report.checks) {
    std::string picture;
    if (isFailure(check.outcome) && check.finding_map && picture_count < kMostPictures) {
      ++picture_count;
      auto png = findingPictureBase64(*check.finding_map);
      if (!png) {
        return tl::make_unexpected(png.error());
      }
      picture = std::move(*png);
    }
    Json row = Json::array();
    for (const std::string& text :
         {std::string(name(check.outcome)), check.id, check.scene,
          check.size.width > 0 ? sizeText(check.size) : "", check.case_name, check.stage, check.device,
          valueWithUnit(check), boundText(check), check.message, check.repro, picture}) {
      row.push_back(texts.add(text));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

// As it may stand in a script element: no "</script>" in it, whatever the data say.
std::string scriptText(const Json& json) {
  std::string safe;
  for (const char byte : jsonText(json, -1)) {
    safe += byte == '<' ? "\\u003c" : std::string(1, byte);
  }
  return safe;
}

Expected<std::string> dataOf(const RunReport& report) {
  TextTable texts;
  auto rows = rowsOf(report, texts);
  if (!rows) {
    return tl::make_unexpected(rows.error());
  }
  Json outcomes = Json::array();
  Json failures = Json::array();
  for (const Outcome outcome : kWorstLast) {
    outcomes.push_back(name(outcome));
    if (isFailure(outcome)) {
      failures.push_back(name(outcome));
    }
  }
  return scriptText({{"columns",
                      {"outcome", "id", "scene", "size", "case", "stage", "device", "value", "bound",
                       "message", "repro", "picture"}},
                     {"outcomes", std::move(outcomes)},
                     {"failures", std::move(failures)},
                     {"strings", texts.texts()},
                     {"rows", std::move(*rows)}});
}

std::string devicesOf(const RunReport& report) {
  std::string rows;
  for (const DeviceRow& device : report.devices) {
    const DeviceIdentity& identity = device.identity;
    rows += "<tr>";
    for (const std::string& text :
         {identity.id, identity.api, identity.driver, identity.version, identity.cpu}) {
      rows += fmt::format("<td>{}</td>", htmlText(plainUtf8(text)));
    }
    rows += "</tr>\n";
  }
  return rows.empty()
             ? ""
             : fmt::format("<h2>Devices</h2>\n<div class=\"scroll\"><table>{}</table></div>\n", rows);
}

std::string ledgerOf(const RunReport& report) {
  if (report.ledger.empty()) {
    return {};
  }
  std::string rows = "<tr>";
  for (const std::string& heading : ledgerHeadings()) {
    rows += fmt::format("<th>{}</th>", htmlText(heading));
  }
  rows += "</tr>\n";
  for (const std::vector<std::string>& row : ledgerRows(report.ledger)) {
    rows += "<tr>";
    for (std::size_t column = 0; column < row.size(); ++column) {
      rows += fmt::format("<td{}>{}</td>", column < 2 ? "" : " class=\"number\"",
                          htmlText(plainUtf8(row[column])));
    }
    rows += "</tr>\n";
  }
  return fmt::format(
      "<h2>Ledger</h2>\n<p class=\"quiet\">How far apart the devices' answers lie. same %: texels with the "
      "same bits; "
      "p50, p99, max: distance in numbers of the buffer's own format; flips: another class, hit texel or "
      "coverage."
      "</p>\n<details{}><summary>{} rows</summary><div class=\"scroll\"><table>{}</table></div></details>\n",
      report.ledger.size() <= 40 ? " open" : "", report.ledger.size(), rows);
}

std::string countsOf(const RunReport& report) {
  std::array<std::size_t, kOutcomeCount> counts{};
  std::vector<Outcome> outcomes;
  for (const CheckResult& check : report.checks) {
    ++counts.at(static_cast<std::size_t>(check.outcome));
    outcomes.push_back(check.outcome);
  }
  std::string text = fmt::format("<p>{}: ", htmlText(closingLine(outcomes)));
  for (const Outcome outcome : kWorstLast) {
    if (const std::size_t count = counts.at(static_cast<std::size_t>(outcome)); count > 0) {
      text += fmt::format("<span class=\"badge {0}\">{1} {0}</span> ", name(outcome), count);
    }
  }
  return text + "</p>\n";
}

constexpr const char* kFilters = R"(<h2>Checks</h2>
<div id="filters">
<label>outcome<select id="outcome"><option value="">all</option><option value="failures">failures</option></select></label>
<label>device<select id="device"><option value="">all</option></select></label>
<label>check<select id="id"><option value="">all</option></select></label>
<label>scene<select id="scene"><option value="">all</option></select></label>
<label>words<input id="search" type="search" placeholder="in any column or message"></label>
</div>
<p class="quiet" id="count"></p>
<div class="scroll"><table id="checks"><thead><tr><th>outcome</th><th>check</th><th>scene</th><th>size</th><th>case</th><th>stage</th><th>device</th><th>value (expected)</th></tr></thead>
<tbody id="rows"></tbody></table></div>
<p><button id="more" hidden>Show more</button></p>
<noscript><p>The table needs JavaScript; the same checks are in checks.csv and results.json.</p></noscript>
)";

}  // namespace

Expected<std::string> checksHtml(const RunReport& report) {
  auto data = dataOf(report);
  if (!data) {
    return data;
  }
  const std::string command = plainUtf8(fmt::format("{}", fmt::join(report.command, " ")));
  std::string page = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width\">\n<meta http-equiv=\"Content-Security-Policy\" content=\"default-src "
      "'none'; "
      "style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:\">\n<title>ssrkit: checks</title>"
      "<style>{}</style></head>\n<body><h1>Checks</h1>\n<p class=\"quiet\">ssrkit {}, {}: "
      "<code>{}</code></p>\n",
      kChecksStyle, htmlText(report.kit_version), htmlText(report.started), htmlText(command));
  page += countsOf(report) + devicesOf(report);
  page +=
      "<h2>Checks by device</h2>\n<p class=\"quiet\">Checks made, or how many of them failed; the colour is "
      "the "
      "worst outcome, and what fails stands first. Choose a cell to see its checks.</p>\n<div "
      "class=\"scroll\"><table class=\"matrix\" "
      "id=\"matrix\"></table></div>\n";
  page += kFilters;
  page += ledgerOf(report);
  page += fmt::format("<script type=\"application/json\" id=\"data\">{}</script>\n<script>{}</script>\n",
                      *data, kChecksScript);
  return page + "</body></html>\n";
}

}  // namespace ssrkit
