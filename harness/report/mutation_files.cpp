#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>

#include "base/json_text.h"
#include "report/html_text.h"
#include "report/json_parts.h"
#include "report/mutation_report.h"

namespace ssrkit {

namespace {

constexpr const char* kMutationStyle = R"(
body { font: 15px/1.45 system-ui, sans-serif; margin: 2rem; color: #1a1a1a; }
table { border-collapse: collapse; font: 11px ui-monospace, monospace; }
thead th { height: 19rem; vertical-align: bottom; padding: 0; }
thead th div { writing-mode: vertical-rl; transform: rotate(180deg); white-space: nowrap; padding: .3rem 0; }
tbody th { text-align: left; white-space: nowrap; padding-right: .6rem; font-weight: normal; }
td { width: 1.1rem; min-width: 1.1rem; height: 1.1rem; border: 1px solid #e4e4e4; text-align: center; padding: 0; }
td.looked { background: #f1f1f1; } td.noticed { background: #2f7d6b; } td.foretold { background: #8fd9c0; }
tr.bad th { font-weight: 700; color: #a3200d; }
)";

// The columns: the suite, and what else noticed something.
std::set<std::string> checksOf(const MutationReport& report) {
  std::set<std::string> columns;
  for (const MutantRun& run : report.runs) {
    for (const auto& [check, has_noticed] : run.noticed) {
      columns.insert(check);
    }
  }
  return columns;
}

Json runOf(const MutantRun& run) {
  Json complaints = Json::object();
  for (const auto& [check, complaint] : run.said) {
    complaints[check] = complaint;
  }
  Json looked = Json::array();
  for (const auto& [check, has_noticed] : run.noticed) {
    looked.push_back(check);
  }
  return {{"name", run.mutant.name},
          {"kind", run.mutant.is_wheat ? "wheat" : "mutant"},
          {"file", run.mutant.edit.file.string()},
          {"about", run.mutant.about},
          {"signature", run.mutant.signature},
          {"killed_by", run.mutant.killed_by},
          {"passed", !isFailure(run)},
          {"problem", run.problem},
          {"noticed_by", killersOf(run)},
          {"complaints", complaints},
          {"looked_at_by", looked},
          {"time_s", run.time_s}};
}

std::string cellOf(const MutantRun& run, const std::string& check) {
  const auto found = run.noticed.find(check);
  if (found == run.noticed.end()) {
    return "<td></td>";
  }
  const bool is_foretold = check == run.mutant.killed_by;
  const char* kind = !found->second ? "looked" : is_foretold ? "noticed foretold" : "noticed";
  const auto said = run.said.find(check);
  return fmt::format("<td class=\"{}\" title=\"{}: {}{}\"></td>", kind, htmlText(run.mutant.name),
                     htmlText(check), said == run.said.end() ? "" : htmlText(" - " + said->second));
}

}  // namespace

std::string mutationJson(const MutationReport& report) {
  const KillSummary summary = summarise(report.runs, report.suite);
  Json runs = Json::array();
  for (const MutantRun& run : inOrder(report.runs)) {
    runs.push_back(runOf(run));
  }
  const Json json = {{"schema", "ssrkit-mutate"},
                     {"schema_version", kMutationSchemaVersion},
                     {"kit_version", report.kit_version},
                     {"started", report.started},
                     {"command", report.command},
                     {"time_s", report.time_s},
                     {"whole", report.is_whole},
                     {"mutants", summary.mutants},
                     {"killed", summary.killed},
                     {"survivors", summary.survivors},
                     {"killed_by_another", summary.unexpected_killers},
                     {"wheats", summary.wheats},
                     {"rejected", summary.rejected},
                     {"copies", summary.copies},
                     {"idle", summary.idle},
                     {"needed", summary.needed},
                     {"runs", runs}};
  return jsonText(json, 2) + "\n";
}

std::string killMatrixCsv(const MutationReport& report) {
  const std::set<std::string> columns = checksOf(report);
  std::string text = "name,kind,file";  // none of which holds a comma
  for (const std::string& check : columns) {
    text += "," + check;
  }
  for (const MutantRun& run : inOrder(report.runs)) {
    text += fmt::format("\n{},{},{}", run.mutant.name, run.mutant.is_wheat ? "wheat" : "mutant",
                        run.mutant.edit.file.string());
    for (const std::string& check : columns) {
      const auto found = run.noticed.find(check);
      text += found == run.noticed.end() ? "," : found->second ? ",1" : ",0";
    }
  }
  return text + "\n";
}

std::string mutationHtml(const MutationReport& report) {
  const KillSummary summary = summarise(report.runs, report.suite);
  const std::set<std::string> columns = checksOf(report);
  std::string text = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Mutants of ssrkit</title>"
      "<style>{}</style></head>\n<body><h1>Mutants and the checks that notice them</h1>\n"
      "<p>{}: {} of {} mutants killed, {} of {} wheats rejected. Dark: the check failed; light green: the "
      "check that "
      "was foretold; grey: it ran and held; white: it does not look at what the mutant changes.</p>\n"
      "<table><thead><tr><th></th>",
      kMutationStyle, htmlText(report.started), summary.killed, summary.mutants, summary.rejected,
      summary.wheats);
  for (const std::string& check : columns) {
    text += fmt::format("<th><div>{}</div></th>", htmlText(check));
  }
  text += "</tr></thead>\n<tbody>\n";
  for (const MutantRun& run : inOrder(report.runs)) {
    text += fmt::format("<tr{}><th title=\"{}\">{}{}</th>", isFailure(run) ? " class=\"bad\"" : "",
                        htmlText(run.mutant.about), run.mutant.is_wheat ? "wheat: " : "",
                        htmlText(run.mutant.name));
    for (const std::string& check : columns) {
      text += cellOf(run, check);
    }
    text += "</tr>\n";
  }
  return text + "</tbody></table></body></html>\n";
}

}  // namespace ssrkit
