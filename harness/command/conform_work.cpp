#include "command/conform_work.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "base/share_out.h"
#include "conform/extra_tests.h"
#include "conform/plan.h"

namespace ssrkit {

namespace {

// Under the run's mutex.
Expected<void> keep(ConformRun& run, std::vector<CellRecord> records) {
  for (CellRecord& record : records) {
    record.inputs = run.inputs.at(record.id);
    if (auto written = run.store.write(record); !written) {
      return written;
    }
    dropMaps(record, run.finding_maps);
    run.failed += isFailure(outcomeOf(record)) ? 1 : 0;
    run.records.emplace(record.id, std::move(record));
  }
  return {};
}

void work(ConformRun& run, const std::vector<Cell>& group, ConformLane& lane) {
  {
    const std::lock_guard lock(run.mutex);
    if (run.failure) {
      return;
    }
    run.progress.show(fmt::format("{}/{} cells, {} failed: {}", run.records.size(), run.plan->own.size(),
                                  run.failed, groupId(group.front())));
  }
  auto records = lane.run(group);
  const std::lock_guard lock(run.mutex);
  const auto kept = records ? keep(run, std::move(*records)) : tl::make_unexpected(records.error());
  if (!kept && !run.failure) {
    run.failure = kept.error();
  }
}

// The record of a cell whose device is not there. It is without inputs: `--resume` tries again.
std::optional<CellRecord> absentCell(const ConformRun& run, const Cell& cell) {
  const auto absent =
      std::ranges::find(run.manifest.absent, cell.device, &std::pair<std::string, std::string>::first);
  if (absent == run.manifest.absent.end()) {
    return std::nullopt;
  }
  const bool is_optional = std::ranges::find(run.plan->optional, cell.device) != run.plan->optional.end();
  return CellRecord{.id = cellId(cell),
                    .checks = {{.id = cell.test + ".runs",
                                .scene = cell.scene,
                                .device = cell.device,
                                .size = cell.size,
                                .outcome = is_optional ? Outcome::kSkip : Outcome::kError,
                                .metric = "runs",
                                .message = absent->second,
                                .repro = conformCommandFor({cellId(cell)})}}};
}

}  // namespace

Expected<void> divideWork(ConformRun& run) {
  std::vector<Cell> left;
  for (const Cell& cell : run.plan->own) {
    const std::string id = cellId(cell);
    auto finished = run.options->resume ? run.store.finished(id, run.inputs.at(id)) : std::nullopt;
    if (finished) {
      dropMaps(*finished, run.finding_maps);
      run.records.emplace(id, std::move(*finished));
      continue;
    }
    auto done = run.store.remove(id);
    if (auto absent = absentCell(run, cell)) {
      done = done.and_then([&] { return run.store.write(*absent); });
      run.records.emplace(id, std::move(*absent));
    } else {
      left.push_back(cell);
    }
    if (!done) {
      return done;
    }
  }
  run.groups = groupsOf(left);
  return {};
}

Expected<void> workThrough(ConformRun& run, const MakeSuite& make_suite, int lanes) {
  shareOut(static_cast<int>(run.groups.size()), lanes, [&](int) -> Lane {
    return
        [&run, lane = std::make_shared<ConformLane>(*run.plan, run.store, make_suite, run.options->repeat)](
            int i) { work(run, run.groups[static_cast<std::size_t>(i)], *lane); };
  });
  run.progress.clear();
  return run.failure ? Expected<void>(tl::make_unexpected(*run.failure)) : Expected<void>{};
}

}  // namespace ssrkit
