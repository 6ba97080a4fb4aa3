#include "check/judge.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/share_out.h"
#include "base/size.h"
#include "check/evaluate.h"

namespace ssrkit {

namespace {

bool isTruthItself(const Truth& truth, const Answer& answer) {
  switch (truth.kind) {
    case TruthKind::kStage:
      return answer.stage == truth.name;
    case TruthKind::kCross:
      return answer.device == truth.name;
    case TruthKind::kCase:
      return answer.stage.empty() ? sharesFrame(answer, truth.name) : answer.case_name == truth.name;
    case TruthKind::kSize:
      return sizeText(answer.size) == truth.name;
    case TruthKind::kRendered:
      return answer.input.empty();
    case TruthKind::kNone:
    case TruthKind::kOracle:
    case TruthKind::kGeometry:
    case TruthKind::kClosedForm:
    case TruthKind::kGolden:
      return false;
  }
  return false;
}

bool isAmong(const std::vector<std::string>& names, const std::string& name_sought) {
  return std::ranges::find(names, name_sought) != names.end();
}

bool framesAnyOf(const Answer& frame, const std::vector<std::string>& cases) {
  return frame.frame_cases.empty() || std::ranges::any_of(cases, [&](const std::string& case_name) {
           return sharesFrame(frame, case_name);
         });
}

CheckResult missing(const TestFile& test, const Expectation& expectation, const std::string& scene) {
  CheckResult result;
  result.id = test.id + "." + expectation.name;
  result.scene = scene;
  result.outcome = Outcome::kMissing;
  result.metric = row(expectation.metric).name;
  result.unit = row(expectation.metric).unit;
  result.max = expectation.max;
  result.min = expectation.min;
  result.message = fmt::format("missing: {} {}\n  problem   no answer of the run is one that {} asks for",
                               result.id, scene, expectation.where);
  return result;
}

// What one answer is asked, and the place of the verdict among all.
struct Asked {
  std::size_t place = 0;
  const Expectation* expectation = nullptr;
  Subject subject;
};

}  // namespace

bool isAskedOf(const TestFile& test, const Expectation& expectation, const Answer& answer) {
  const bool of_frame = expectation.stages.empty();
  const bool stage_fits = of_frame ? answer.stage.empty() : isAmong(expectation.stages, answer.stage);
  const bool over_cases = row(expectation.metric).over_cases;
  const bool case_fits = over_cases ? answer.case_name == expectation.cases.front()
                         : of_frame ? framesAnyOf(answer, expectation.cases)
                                    : isAmong(expectation.cases, answer.case_name);
  const bool size_fits = expectation.sizes.empty() ||
                         std::ranges::find(expectation.sizes, answer.size) != expectation.sizes.end();
  const bool device_fits = !expectation.devices || isAmong(*expectation.devices, answer.device);
  return !answer.is_made && stage_fits && case_fits && size_fits && device_fits &&
         answer.input == test.input && !isTruthItself(expectation.truth, answer);
}

std::vector<CheckResult> judge(const TestFile& test, const std::string& scene,
                               std::span<const Answer> answers,
                               const std::function<std::string(const Answer&)>& repro,
                               const GoldenLookup& golden) {
  std::vector<CheckResult> results;
  std::vector<Asked> asked;
  for (const Expectation& expectation : test.expectations) {
    const std::size_t before = results.size();
    for (const Answer& answer : answers) {
      if (isAskedOf(test, expectation, answer)) {
        const bool wants_golden = expectation.truth.kind == TruthKind::kGolden && golden;
        const Answer* const blessed = wants_golden ? golden(expectation, answer) : nullptr;
        asked.push_back({results.size(), &expectation,
                         Subject{test.id, scene, &answer, answers, repro(answer), blessed}});
        results.emplace_back();
      }
    }
    // One that is asked of some devices only is not missed on the others.
    const bool is_for_others =
        expectation.devices && std::ranges::none_of(answers, [&](const Answer& answer) {
          return isAmong(*expectation.devices, answer.device);
        });
    if (results.size() == before && !is_for_others) {
      results.push_back(missing(test, expectation, scene));
    }
  }
  forEachInParallel(static_cast<int>(asked.size()), 0, [&](int i) {
    const Asked& one = asked[static_cast<std::size_t>(i)];
    results[one.place] = evaluate(*one.expectation, one.subject);
  });
  return results;
}

}  // namespace ssrkit
