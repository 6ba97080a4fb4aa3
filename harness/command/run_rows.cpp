#include "command/run_rows.h"

#include "check/geometry_verdict.h"

namespace ssrkit {

namespace {

std::optional<TrueClassSummary> trueClassesOf(const CellRun& cell, std::size_t trace,
                                              const std::vector<Verdict>& verdicts) {
  const CellRun::Truth* truth = cell.truth_of_trace.empty() ? nullptr : cell.truth_of_trace[trace];
  if (truth == nullptr || truth->geometry == nullptr) {
    return std::nullopt;
  }
  const RayRecord& record = cell.result->traces[trace].record;
  return summarise(*truth->geometry, compareWithGeometry(record, *truth->geometry, truth->input), verdicts);
}

Outcome worstOutcome(const SceneRun& run, const CellRun& cell, const TraceResult& trace) {
  Outcome worst = Outcome::kPass;
  for (const CheckResult& check : run.checks) {
    const bool concerns = check.device == cell.device && check.size == cell.size &&
                          (check.stage == trace.stage || check.stage.empty());
    if (!concerns) {
      continue;
    }
    const bool is_worse = isFailure(check.outcome)
                              ? !isFailure(worst)
                              : worst == Outcome::kPass && check.outcome != Outcome::kPass;
    worst = is_worse ? check.outcome : worst;
  }
  return worst;
}

}  // namespace

std::vector<Verdict> verdictsOf(const CellRun& cell, std::size_t trace) {
  const CellRun::Truth* truth = cell.truth_of_trace.empty() ? nullptr : cell.truth_of_trace[trace];
  return truth == nullptr ? std::vector<Verdict>{}
                          : compareWithOracle(cell.result->traces[trace].record, truth->result, truth->input);
}

std::vector<RunRow> runRows(const SceneRun& run) {
  std::vector<RunRow> rows;
  for (const CellRun& cell : run.cells) {
    if (!cell.result) {
      continue;
    }
    for (std::size_t i = 0; i < cell.result->traces.size(); ++i) {
      const TraceResult& trace = cell.result->traces[i];
      const std::vector<Verdict> verdicts = verdictsOf(cell, i);
      rows.push_back({.scene = run.source->name,
                      .device = cell.device,
                      .stage = trace.stage,
                      .case_name = cell.case_of_trace[i],
                      .size = cell.size,
                      .parameters = trace.parameters,
                      .outcome = worstOutcome(run, cell, trace),
                      .summary = summarise(trace.record, verdicts),
                      .true_classes = trueClassesOf(cell, i, verdicts),
                      .passes = trace.passes});
    }
  }
  return rows;
}

}  // namespace ssrkit
