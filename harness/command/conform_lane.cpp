#include "command/conform_lane.h"

#include <fmt/format.h>

#include <algorithm>

#include "command/conform_pictures.h"
#include "conform/extra_tests.h"
#include "conform/isolate.h"
#include "report/ledger_table.h"

namespace ssrkit {

namespace {

bool isAmong(const std::vector<std::string>& names, const std::string& name_sought) {
  return std::ranges::find(names, name_sought) != names.end();
}

bool gaveNoAnswer(const SceneRun& run, const std::string& device) {
  return std::ranges::any_of(
      run.cells, [&](const CellRun& cell) { return cell.device == device && (!cell.result || cell.error); });
}

// A check that concerns the cell as a whole.
CheckResult cellCheck(const Cell& cell, Outcome outcome, const std::string& message) {
  return {.id = cell.test + ".runs",
          .scene = cell.scene,
          .device = cell.device,
          .size = cell.size,
          .outcome = outcome,
          .metric = "runs",
          .message = message,
          .repro = conformCommandFor({cellId(cell)})};
}

// What the test asks of the device but nobody answered.
void addMissing(const TestFile& test, const Cell& cell, std::vector<CheckResult>& checks) {
  for (const Expectation& expectation : test.expectations) {
    const bool is_truth_itself =
        expectation.truth.kind == TruthKind::kCross && expectation.truth.name == cell.device;
    const bool is_asked = !expectation.devices || isAmong(*expectation.devices, cell.device);
    const bool size_fits = expectation.sizes.empty() ||
                           std::ranges::find(expectation.sizes, cell.size) != expectation.sizes.end();
    const std::string id = test.id + "." + expectation.name;
    if (is_asked && size_fits && !is_truth_itself &&
        std::ranges::find(checks, id, &CheckResult::id) == checks.end()) {
      CheckResult missing = cellCheck(cell, Outcome::kMissing,
                                      "no answer of the run is one that " + expectation.where + " asks for");
      missing.id = id;
      missing.metric = row(expectation.metric).name;
      checks.push_back(std::move(missing));
    }
  }
}

}  // namespace

ConformLane::Once ConformLane::collect(const TestFile& test, const Cell& cell, const SceneRun& run) const {
  Once once;
  for (const CheckResult& check : run.checks) {
    if (check.device == cell.device) {
      once.checks.push_back(check);
    }
  }
  // A pair belongs to the cell of its second device, so that shards and merged runs count it once.
  for (const auto& [key, entry] : overStages(run.ledger)) {
    if (key.other == cell.device && !isExtraTest(cell.test)) {
      once.ledger.emplace(key, entry);
    }
  }
  for (const CellRun& job : run.cells) {
    once.time_s += job.device == cell.device ? job.time_s : 0.0;
  }
  if (gaveNoAnswer(run, cell.device)) {
    return once;
  }
  for (const std::string& reference : referencesOf(test, cell.device)) {
    if (reference != cell.device && gaveNoAnswer(run, reference)) {
      blameReference(once, cell, reference);
      return once;
    }
  }
  addMissing(test, cell, once.checks);
  return once;
}

// What could not be judged is the reference's fault, and counts there: here it is skipped, unless the
// reference is no part of the run, where nobody else would tell.
void ConformLane::blameReference(Once& once, const Cell& cell, const std::string& reference) const {
  Cell its_cell = cell;
  its_cell.device = reference;
  const bool is_told = std::ranges::find(plan_->own, its_cell) != plan_->own.end();
  const Outcome outcome = is_told ? Outcome::kSkip : Outcome::kError;
  const std::string message = fmt::format("not judged: {}, which it is held against, gave no answer{}",
                                          reference, is_told ? "; see its own cell" : "");
  once.has_lost_truth = true;
  for (CheckResult& check : once.checks) {
    if (check.outcome == Outcome::kError) {
      check.outcome = outcome;
      check.message = message;
    }
  }
  if (once.checks.empty()) {
    once.checks.push_back(cellCheck(cell, outcome, message));
  }
}

ConformLane::Group ConformLane::runOnce(Suite& suite, std::span<const Cell> group, Pictures pictures) const {
  const Cell& first = group.front();
  TestFile test = plan_->test(first);
  Group result{.cells = {}, .devices = {}, .dead = {}, .failure = std::nullopt};
  for (const Cell& cell : group) {
    std::vector<std::string> devices = referencesOf(test, cell.device);
    devices.push_back(cell.device);
    std::ranges::copy_if(devices, std::back_inserter(result.devices),
                         [&](const std::string& device) { return !isAmong(result.devices, device); });
  }
  test.devices = result.devices;
  test.sizes = {first.size};
  suite.setCommand([first](const std::string& device) {
    Cell cell = first;
    cell.device = device;
    return conformCommandFor({cellId(cell)});
  });
  suite.setExtraPasses(passesOf(first.test));
  const SceneRun run = suite.run(test, plan_->source(first));
  for (const CellRun& job : run.cells) {
    if (job.death) {
      result.dead.push_back(job.device);
    }
  }
  for (const Cell& cell : group) {
    result.cells.emplace(cell.device, collect(test, cell, run));
    if (pictures == Pictures::kOfFailures && !result.failure) {
      const auto written = writeFailurePictures(test, cell, run, *store_);
      result.failure = written ? std::nullopt : std::optional(written.error());
    }
  }
  return result;
}

void ConformLane::remember(const Cell& any_of_group, const Group& group) {
  for (const std::string& device : group.devices) {
    if (isAmong(group.dead, device)) {
      history_[device].clear();
      continue;
    }
    Cell cell = any_of_group;
    cell.device = device;
    history_[device].push_back(std::move(cell));
  }
}

Expected<std::map<std::string, ConformLane::Once>> ConformLane::runRepeatedly(std::span<const Cell> group) {
  std::map<std::string, std::vector<std::vector<CheckResult>>> runs;
  std::map<std::string, Once> results;
  for (int i = 0; i < repeat_; ++i) {
    Group once = runOnce(*suite_, group, Pictures::kOfFailures);
    if (once.failure) {
      return tl::make_unexpected(*once.failure);
    }
    remember(group.front(), once);
    for (auto& [device, result] : once.cells) {
      runs[device].push_back(std::move(result.checks));
      results[device].time_s += result.time_s;
      results[device].ledger = std::move(result.ledger);
      results[device].has_lost_truth = results[device].has_lost_truth || result.has_lost_truth;
    }
  }
  for (auto& [device, result] : results) {
    result.checks = repeat_ > 1 ? combineRepeats(runs[device]) : std::move(runs[device].front());
  }
  return results;
}

// A reference that died once may answer the next time: those that are held against it get a second chance.
Expected<void> ConformLane::runDependentsAgain(std::span<const Cell> group,
                                               std::map<std::string, Once>& results) {
  std::vector<Cell> dependents;
  std::ranges::copy_if(group, std::back_inserter(dependents),
                       [&](const Cell& cell) { return results.at(cell.device).has_lost_truth; });
  if (dependents.empty()) {
    return {};
  }
  const auto fresh = make_suite_();
  if (!fresh) {
    return tl::make_unexpected(fresh.error());
  }
  for (auto& [device, once] : runOnce(**fresh, dependents, Pictures::kNone).cells) {
    results[device] = std::move(once);
  }
  return {};
}

std::vector<CheckResult> ConformLane::runApart(const Cell& cell, std::span<const Cell> before) {
  const auto fresh = make_suite_();
  if (!fresh) {
    return {cellCheck(cell, Outcome::kError, sentence(fresh.error()))};
  }
  for (const Cell& earlier : before) {
    static_cast<void>(runOnce(**fresh, std::span(&earlier, 1), Pictures::kNone));
  }
  return runOnce(**fresh, std::span(&cell, 1), Pictures::kNone).cells.at(cell.device).checks;
}

Expected<std::vector<CellRecord>> ConformLane::run(std::span<const Cell> group) {
  if (!suite_) {
    auto made = make_suite_();
    if (!made) {
      return tl::make_unexpected(made.error());
    }
    suite_ = std::move(*made);
  }
  const std::map<std::string, std::vector<Cell>> before = history_;
  auto results = runRepeatedly(group);
  const auto done =
      results ? runDependentsAgain(group, *results) : Expected<void>(tl::make_unexpected(results.error()));
  if (!done) {
    return tl::make_unexpected(done.error());
  }
  std::vector<CellRecord> records;
  for (const Cell& cell : group) {
    Once& once = results->at(cell.device);
    const auto preceding = before.find(cell.device);
    Isolated isolated = isolate(
        cell, std::move(once.checks), preceding == before.end() ? std::span<const Cell>{} : preceding->second,
        [this](const Cell& alone, std::span<const Cell> earlier) { return runApart(alone, earlier); });
    records.push_back({.id = cellId(cell),
                       .inputs = "",
                       .time_s = once.time_s,
                       .attempts = repeat_ + isolated.extra_runs,
                       .checks = std::move(isolated.checks),
                       .ledger = std::move(once.ledger)});
  }
  return records;
}

}  // namespace ssrkit
