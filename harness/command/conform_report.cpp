#include "command/conform_report.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <iterator>

#include "check/read_baseline.h"
#include "command/known_names.h"
#include "command/print_checks.h"
#include "conform/outcome_table.h"
#include "report/ledger_table.h"
#include "report/report_files.h"
#include "report/results_json.h"
#include "report/table.h"

namespace ssrkit {

namespace {

RunReport runReport(const ConformReport& conform) {
  RunReport report{.kit_version = conform.manifest.kit_version,
                   .started = conform.manifest.started,
                   .command = conform.command,
                   .devices = conform.manifest.devices};
  for (const CellRecord& record : conform.records) {
    report.cells.push_back({.id = record.id,
                            .outcome = outcomeOf(record),
                            .checks = record.checks.size(),
                            .time_s = record.time_s,
                            .attempts = record.attempts});
    addToLedger(record.ledger, report.ledger);
    for (const CheckResult& check : record.checks) {
      report.checks.push_back(check);
      report.checks.back().time_s = record.time_s / static_cast<double>(record.checks.size());
    }
  }
  return report;
}

// Each record's checks are judged again; what the list itself is to blame for (an entry past its date) comes
// as a record of its own.
void judgeByKnownFailures(ConformReport& conform) {
  DeviceTexts devices;
  for (const DeviceRow& device : conform.manifest.devices) {
    const DeviceIdentity& identity = device.identity;
    devices[identity.id] = fmt::format("{} {} {}", identity.api, identity.driver, identity.version);
  }
  std::vector<CheckResult> checks;
  for (CellRecord& record : conform.records) {
    std::ranges::move(record.checks, std::back_inserter(checks));
  }
  const auto today = std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now());
  for (const KnownFailure* unused : applyBaseline(conform.known_failures, devices, today, checks)) {
    if (conform.is_whole) {
      conform.notes.push_back(
          fmt::format("{}: the expected failure of '{}' on '{}' fits no check of this run", unused->where,
                      unused->id, unused->device));
    }
  }
  auto next = std::make_move_iterator(checks.begin());
  for (CellRecord& record : conform.records) {
    for (CheckResult& check : record.checks) {
      check = *next++;
    }
  }
  if (next != std::make_move_iterator(checks.end())) {
    conform.records.push_back(
        {.id = "known-failures", .checks = {next, std::make_move_iterator(checks.end())}});
  }
}

bool isWorthTelling(const CheckResult& check) {
  return isFailure(check.outcome) || check.outcome == Outcome::kFlake ||
         check.outcome == Outcome::kInconclusive;
}

// A broken driver fails everywhere: the first failures tell the story, results.json has them all.
void printFailures(const RunReport& report) {
  constexpr std::size_t kMost = 40;
  std::size_t told = 0;
  for (const CheckResult& check : report.checks) {
    if (isWorthTelling(check) && told++ < kMost) {
      fmt::print("\n");
      printCheck(check);
    }
  }
  if (told > kMost) {
    fmt::print("\n... and {} more, in results.json\n", told - kMost);
  }
}

// One line for each device that is not there, and why.
void printAbsent(const Manifest& manifest) {
  for (const auto& [device, reason] : manifest.absent) {
    fmt::print("\nabsent: {}: {}\n", device, reason);
  }
}

// Before the closing line, also where both streams go to the same place.
void printFailure(const ConformReport& conform) {
  if (conform.failure) {
    std::fflush(stdout);
    fmt::print(stderr, "ssrkit: {}\n", sentence(*conform.failure));
  }
}

}  // namespace

Expected<std::vector<KnownFailure>> readKnownFailures(const std::filesystem::path& file,
                                                      const KitPaths& paths) {
  return loadBaseline(file.empty() ? paths.known_failures : file, knownNames(paths));
}

Expected<int> finishConform(ConformReport conform) {
  judgeByKnownFailures(conform);
  const RunReport report = runReport(conform);
  if (const auto written = writeReportFiles(conform.out, report); !written) {
    return tl::make_unexpected(written.error());
  }
  const std::vector<Outcome> outcomes = outcomesOf(report);
  const int code = conform.failure ? exitCode(*conform.failure) : exitCode(outcomes);
  if (conform.json) {
    fmt::print("{}", resultsJson(report));
    printFailure(conform);
    return code;
  }
  fmt::print("{}", outcomeTable(conform.records, wantsColour(STDOUT_FILENO)));
  if (const std::string ledger = ledgerTable(report.ledger); !ledger.empty()) {
    fmt::print("\nhow far the devices lie apart, in ulps of each buffer\n{}", ledger);
  }
  printAbsent(conform.manifest);
  printFailures(report);
  for (const std::string& note : conform.notes) {
    fmt::print("\nnote: {}\n", note);
  }
  const auto unsure = std::ranges::count_if(outcomes, [](Outcome outcome) {
    return outcome == Outcome::kFlake || outcome == Outcome::kInconclusive;
  });
  fmt::print("\n{} cells, written to {}\n", conform.records.size(), conform.out.string());
  if (unsure > 0) {
    fmt::print("{} flaky or inconclusive\n", unsure);
  }
  printFailure(conform);
  fmt::print("{}\n", closingLine(outcomes));
  return code;
}

}  // namespace ssrkit
