// One job of a run, with everything that its answers are held against.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "check/check_result.h"
#include "check/subject.h"
#include "frame/job.h"
#include "oracle/geometry.h"
#include "oracle/oracle.h"
#include "worker/supervisor.h"

namespace ssrkit {

// One device's answer to one job, with the oracle's.
struct CellRun {
  std::string device;
  Size size;
  std::string native_peer;         // that traced in the device's place, "" none (native_cells.h)
  std::string input;               // the device whose G-buffer was uploaded, "" its own
  std::string variant;             // of the job, "" the plain one
  std::vector<std::string> cases;  // that the job was drawn for, in order
  std::optional<JobResult> result;
  std::optional<Error> error;
  std::optional<WorkerDeath> death;
  double time_s = 0.0;          // of the worker, its start included
  Image mask;                   // 1 channel, from the material
  std::deque<Image> own_masks;  // of techniques that give their tracer a material of their own
  // Oracle A by the parameters that it depends on; stable addresses.
  struct Truth {
    OracleInput input;
    OracleResult result;
    const GeometryResult* geometry = nullptr;  // Oracle B's, null where it was not asked
  };
  std::deque<Truth> truths;
  std::deque<GeometryResult> geometries;     // by the parameters that Oracle B depends on; stable addresses
  std::optional<Image> true_dist_view;       // where a check is held against it
  std::vector<const Truth*> truth_of_trace;  // one a trace, null where no oracle was asked for
  std::vector<std::string> case_of_trace;
};

// The reflective pixels of a G-buffer: 1 channel, from the material; empty without a material.
[[nodiscard]] Image maskOf(const std::map<std::string, Image>& images);

// Adds the timed rounds of the same job, drawn once more: its first draws were warm-up.
void appendRounds(CellRun& cell, const JobResult& again);

// Asks Oracle A about every trace of the cell; cases that differ in nothing that it looks at share its
// answer.
void addTruths(CellRun& cell);

// The cell's answers: the frame's images, then one a trace. They point into the cell.
void addAnswers(const CellRun& cell, std::vector<Answer>& answers);

// What went wrong with the cell as a whole, as checks whose names, scenes and commands are still to be filled
// in: why it has no answers, each message of its driver, each trace whose loop the driver cut short.
[[nodiscard]] CheckResult failureOf(const CellRun& cell);
[[nodiscard]] std::vector<CheckResult> messagesOf(const CellRun& cell);
[[nodiscard]] std::vector<CheckResult> limitedTracesOf(const CellRun& cell);

// Divides the time of each device's jobs among the device's checks.
void shareTimes(const std::deque<CellRun>& cells, std::vector<CheckResult>& checks);

}  // namespace ssrkit
