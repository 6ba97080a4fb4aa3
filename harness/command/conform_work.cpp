#include "command/conform_work.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <thread>

#include "conform/plan.h"

namespace ssrkit {

namespace {

// The page shows the first few failures in pictures: the maps of a broken driver's ten thousand cells would
// fill the memory.
void dropMaps(CellRecord& record, std::size_t& kept) {
  constexpr std::size_t kMost = 100;
  for (CheckResult& check : record.checks) {
    if (check.finding_map && ++kept > kMost) {
      check.finding_map.reset();
    }
  }
}

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

void work(ConformRun& run, std::atomic<std::size_t>& next, ConformLane lane) {
  for (std::size_t i = next++; i < run.groups.size(); i = next++) {
    {
      const std::lock_guard lock(run.mutex);
      if (run.failure) {
        return;
      }
      run.progress.show(fmt::format("{}/{} cells, {} failed: {}", run.records.size(), run.plan->own.size(),
                                    run.failed, groupId(run.groups[i].front())));
    }
    auto records = lane.run(run.groups[i]);
    const std::lock_guard lock(run.mutex);
    const auto kept = records ? keep(run, std::move(*records)) : tl::make_unexpected(records.error());
    if (!kept && !run.failure) {
      run.failure = kept.error();
    }
  }
}

}  // namespace

// groups.
Expected<void> divideWork(ConformRun& run) {
  std::vector<Cell> left;
  for (const Cell& cell : run.plan->own) {
    const std::string id = cellId(cell);
    auto finished = run.options->resume ? run.store.finished(id, run.inputs.at(id)) : std::nullopt;
    const auto absent =
        std::ranges::find(run.manifest.absent, cell.device, &std::pair<std::string, std::string>::first);
    if (finished) {
      run.records.emplace(id, std::move(*finished));
    } else if (auto removed = run.store.remove(id); !removed) {
      return removed;
    } else if (absent != run.manifest.absent.end()) {
      run.records.emplace(id, CellRecord{.id = id,
                                         .checks = {{.id = cell.test + ".runs",
                                                     .scene = cell.scene,
                                                     .device = cell.device,
                                                     .size = cell.size,
                                                     .outcome = Outcome::kSkip,
                                                     .metric = "runs",
                                                     .message = absent->second}}});
    } else {
      left.push_back(cell);
    }
  }
  run.groups = groupsOf(left);
  return {};
}

Expected<void> workThrough(ConformRun& run, const MakeSuite& make_suite, int lanes) {
  std::atomic<std::size_t> next = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < lanes; ++i) {
    threads.emplace_back(
        [&] { work(run, next, ConformLane(*run.plan, run.store, make_suite, run.options->repeat)); });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  run.progress.clear();
  return run.failure ? Expected<void>(tl::make_unexpected(*run.failure)) : Expected<void>{};
}

}  // namespace ssrkit
