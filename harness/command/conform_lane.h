// One line of work of a `conform`: workers of its own, and groups of cells one after another.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "command/conform_plan.h"
#include "command/suite.h"
#include "conform/cell.h"
#include "conform/cell_record.h"
#include "conform/cell_store.h"

namespace ssrkit {

using MakeSuite = std::function<Expected<std::unique_ptr<Suite>>()>;

class ConformLane {
 public:
  // `plan` and `store`, which gets pictures of what failed, must outlive the lane. Lanes may run in threads
  // of their own.
  ConformLane(const ConformPlan& plan, const CellStore& store, MakeSuite make_suite, int repeat)
      : plan_(&plan), store_(&store), make_suite_(std::move(make_suite)), repeat_(repeat) {}

  // Runs the cells of one group and gives a record for each, without its inputs' hash. What fails is run
  // again alone, on workers started for it (conform/isolate.h). A suite that cannot be made and a picture
  // that cannot be written are errors.
  [[nodiscard]] Expected<std::vector<CellRecord>> run(std::span<const Cell> group);

 private:
  // One cell of a group, run once.
  struct Once {
    std::vector<CheckResult> checks;
    Ledger ledger;
    double time_s = 0.0;
    bool has_lost_truth = false;  // a device that it is held against gave no answer
  };
  struct Group {
    std::map<std::string, Once> cells;  // by device
    std::vector<std::string> devices;   // that were at work, references included
    std::vector<std::string> dead;      // those whose worker died
    std::optional<Error> failure;       // of a picture
  };
  enum class Pictures { kNone, kOfFailures };

  [[nodiscard]] Group runOnce(Suite& suite, std::span<const Cell> group, Pictures pictures) const;
  [[nodiscard]] Once collect(const TestFile& test, const Cell& cell, const SceneRun& run) const;
  void blameReference(Once& once, const Cell& cell, const std::string& reference) const;
  [[nodiscard]] Expected<std::map<std::string, Once>> runRepeatedly(std::span<const Cell> group);
  [[nodiscard]] Expected<void> runDependentsAgain(std::span<const Cell> group,
                                                  std::map<std::string, Once>& results);
  [[nodiscard]] std::vector<CheckResult> runApart(const Cell& cell, std::span<const Cell> before);
  void remember(const Cell& any_of_group, const Group& group);

  const ConformPlan* plan_;
  const CellStore* store_;
  MakeSuite make_suite_;
  int repeat_;
  std::unique_ptr<Suite> suite_;
  std::map<std::string, std::vector<Cell>>
      history_;  // what each device's worker has run since it was started
};

}  // namespace ssrkit
