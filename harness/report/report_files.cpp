#include "report/report_files.h"

#include "base/atomic_file.h"
#include "report/checks_csv.h"
#include "report/checks_html.h"
#include "report/junit_xml.h"
#include "report/results_json.h"

namespace ssrkit {

Expected<void> writeReportFiles(const std::filesystem::path& folder, const RunReport& report) {
  return writeResultsJson(folder / "results.json", report)
      .and_then([&] { return writeFileAtomically(folder / "checks.csv", checksCsv(report)); })
      .and_then([&] { return writeFileAtomically(folder / "junit.xml", junitXml(report)); })
      .and_then([&] { return checksHtml(report); })
      .and_then([&](const std::string& page) { return writeFileAtomically(folder / "report.html", page); });
}

}  // namespace ssrkit
