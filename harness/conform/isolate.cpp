#include "conform/isolate.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "conform/extra_tests.h"

namespace ssrkit {

namespace {

// Xpass and missing say something about lists and plans, which another run does not change.
bool isRunAgain(const CheckResult& check) {
  return isFailure(check.outcome) && check.outcome != Outcome::kXpass && check.outcome != Outcome::kMissing;
}

const CheckResult* sameCheck(const std::vector<CheckResult>& checks, const CheckResult& wanted) {
  const auto found = std::ranges::find_if(checks, [&](const CheckResult& check) {
    return check.id == wanted.id && check.stage == wanted.stage && check.case_name == wanted.case_name;
  });
  return found == checks.end() ? nullptr : &*found;
}

// A check of the worker itself ("runs", a driver's message) is listed only where it failed.
bool failsIn(const std::vector<CheckResult>& checks, const CheckResult& wanted) {
  const CheckResult* const same = sameCheck(checks, wanted);
  return same != nullptr && isFailure(same->outcome);
}

bool anyFailsIn(const std::vector<CheckResult>& checks, const std::vector<CheckResult>& wanted) {
  return std::ranges::any_of(wanted, [&](const CheckResult& check) { return failsIn(checks, check); });
}

struct Order {
  std::vector<Cell> cells;  // that bring the failure back; empty: none do
};

// The shortest of a few tails of the list that brings the failure back, then halves of it: the culprit is
// mostly near.
Order findOrder(const Cell& cell, const std::vector<CheckResult>& unsteady, std::span<const Cell> preceding,
                const RunApart& run_apart, int& extra_runs) {
  constexpr std::size_t kGrowth = 8;
  const auto brings_back = [&](std::span<const Cell> before) {
    ++extra_runs;
    return anyFailsIn(run_apart(cell, before), unsteady);
  };
  std::span<const Cell> tail;
  bool is_found = false;
  for (std::size_t length = kGrowth; !is_found && tail.size() < preceding.size(); length *= kGrowth) {
    tail = preceding.last(std::min(length, preceding.size()));
    is_found = brings_back(tail);
  }
  while (is_found && tail.size() > 1) {
    const std::size_t half = tail.size() / 2;
    if (brings_back(tail.last(tail.size() - half))) {
      tail = tail.last(tail.size() - half);
    } else if (brings_back(tail.first(half))) {
      tail = tail.first(half);
    } else {
      break;  // it takes cells of both halves
    }
  }
  return {is_found ? std::vector<Cell>(tail.begin(), tail.end()) : std::vector<Cell>{}};
}

void addLines(CheckResult& check, const std::string& text) {
  const std::string again = "\n  again     ";
  const std::size_t at = check.message.rfind(again);
  check.message.insert(at == std::string::npos ? check.message.size() : at, text);
}

void blameOrder(CheckResult& check, const Cell& cell, const std::vector<Cell>& before) {
  const std::string command = conformCommandFor({cellId(before.front()), cellId(cell)}) + " --jobs 1";
  addLines(check,
           fmt::format("\n  order     passes alone; fails after {}{}\n  in order  {}", cellId(before.front()),
                       before.size() > 1 ? fmt::format(" and the {} cells behind it", before.size() - 1) : "",
                       command));
}

void callFlake(CheckResult& check) {
  const std::string was = name(check.outcome);
  check.outcome = Outcome::kFlake;
  addLines(check, fmt::format("\n  flake     was {} once; passes when it is run again alone", was));
}

}  // namespace

Isolated isolate(const Cell& cell, std::vector<CheckResult> checks, std::span<const Cell> preceding,
                 const RunApart& run_apart) {
  Isolated isolated{.checks = std::move(checks)};
  std::vector<CheckResult> unsteady;
  std::ranges::copy_if(isolated.checks, std::back_inserter(unsteady), isRunAgain);
  if (unsteady.empty()) {
    return isolated;
  }
  ++isolated.extra_runs;
  const std::vector<CheckResult> alone = run_apart(cell, {});
  std::erase_if(unsteady, [&](const CheckResult& check) { return failsIn(alone, check); });
  if (!unsteady.empty()) {
    for (const CheckResult& check : alone) {
      if (sameCheck(isolated.checks, check) == nullptr) {
        isolated.checks.push_back(check);  // a dead worker never answered it
      }
    }
    ++isolated.extra_runs;
    const bool is_random = anyFailsIn(run_apart(cell, {}), unsteady);
    const Order order = is_random || preceding.empty()
                            ? Order{}
                            : findOrder(cell, unsteady, preceding, run_apart, isolated.extra_runs);
    for (CheckResult& check : isolated.checks) {
      if (isRunAgain(check) && sameCheck(unsteady, check) != nullptr) {
        order.cells.empty() ? callFlake(check) : blameOrder(check, cell, order.cells);
      }
    }
  }
  return isolated;
}

std::vector<CheckResult> combineRepeats(std::span<const std::vector<CheckResult>> runs) {
  std::vector<CheckResult> combined;
  for (const std::vector<CheckResult>& run : runs) {
    for (const CheckResult& check : run) {
      if (sameCheck(combined, check) == nullptr) {
        combined.push_back(check);
      }
    }
  }
  for (CheckResult& check : combined) {
    std::size_t failures = 0;
    bool is_steady = true;
    for (const std::vector<CheckResult>& run : runs) {
      const CheckResult* const same = sameCheck(run, check);
      failures += same != nullptr && isFailure(same->outcome) ? 1 : 0;
      is_steady = is_steady && same != nullptr && same->value == check.value;
      if (same != nullptr && isFailure(same->outcome) && !isFailure(check.outcome)) {
        check = *same;  // the run that failed has the longer message
      }
    }
    const bool is_mixed = failures > 0 && failures < runs.size();
    if (is_mixed || (failures == 0 && !is_steady)) {
      check.outcome = Outcome::kFlake;
      addLines(check, fmt::format("\n  flake     failed in {} of {} runs{}", failures, runs.size(),
                                  is_mixed ? "" : ", but its value is not the same in all of them"));
    }
  }
  return combined;
}

}  // namespace ssrkit
