#include "check/evaluate.h"

#include <fmt/format.h>

#include "base/check.h"
#include "check/failure_message.h"
#include "check/finding_map.h"
#include "check/measure.h"

namespace ssrkit {

namespace {

bool holds(double value, const Expectation& expectation) {
  // Written so that a NaN holds no bound.
  return (!expectation.max || value <= *expectation.max) && (!expectation.min || value >= *expectation.min);
}

Outcome outcomeOf(const Measurement& measurement, const Expectation& expectation) {
  if (!measurement.problem.empty()) {
    return Outcome::kError;
  }
  if (measurement.compared == 0) {
    return expectation.allow_empty ? Outcome::kPass : Outcome::kFail;
  }
  if (measurement.outcome) {
    return *measurement.outcome;
  }
  return measurement.value && holds(*measurement.value, expectation) ? Outcome::kPass : Outcome::kFail;
}

// A golden is only ever made by hand: a run that made its own would pass whatever it drew.
std::string missingGolden(const Expectation& expectation, const Subject& subject) {
  return fmt::format(
      "no golden of '{}' fits {}; find out whether what it draws is right, then ./ssrkit bless {} --scene {} "
      "--device {} --why \"...\"",
      expectation.buffer, subject.self->device, subject.test_id, subject.scene, subject.self->device);
}

}  // namespace

CheckResult evaluate(const Expectation& expectation, const Subject& subject) {
  SSRKIT_CHECK(subject.self != nullptr);
  const Answer& self = *subject.self;
  const bool lacks_golden = expectation.truth.kind == TruthKind::kGolden && subject.golden == nullptr;
  Measurement measurement =
      lacks_golden ? cannotMeasure(missingGolden(expectation, subject)) : measure(expectation, subject);
  CheckResult result;
  result.id = subject.test_id + "." + expectation.name;
  result.scene = subject.scene;
  result.device = self.device;
  result.stage = self.stage;
  result.size = self.size;
  result.case_name = self.case_name;
  if (!self.stage.empty()) {
    result.parameters = self.parameters;
  }
  result.metric = row(expectation.metric).name;
  result.unit = row(expectation.metric).unit;
  result.value = measurement.value;
  result.interval = measurement.interval;
  result.histogram = measurement.histogram;
  result.compared = measurement.compared;
  result.max = expectation.max;
  result.min = expectation.min;
  result.repro = subject.repro;
  result.outcome = lacks_golden ? Outcome::kMissing : outcomeOf(measurement, expectation);
  const bool empty = measurement.problem.empty() && measurement.compared == 0;
  if (empty) {
    const bool of_rays = measurement.compared_what == "rays";
    measurement.remark =
        of_rays ? "no ray was compared" : "no " + measurement.compared_what + " were compared";
  }
  result.remark = measurement.problem.empty() ? measurement.remark : measurement.problem;
  if (result.outcome == Outcome::kPass) {
    result.message = measurement.remark;
  } else {
    if (!measurement.findings.empty()) {
      result.finding_map = findingMap(self.size, measurement.findings);
    }
    result.message = failureMessage(result, expectation, std::move(measurement));
  }
  return result;
}

}  // namespace ssrkit
