#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "check/measure.h"
#include "check/percentile.h"
#include "check/ray_pairs.h"
#include "oracle/image_ray.h"

namespace ssrkit {

namespace {

// Below this an error is rounding, and need not fall any further.
constexpr double kRoundingPx = 1.0 / 64.0;

// The case's answer with its record in order, or a problem.
struct CaseAnswer {
  const Answer* answer = nullptr;
  std::string problem;
};

CaseAnswer caseAnswer(const Subject& subject, const std::string& case_name) {
  const Answer* answer = answerOfCase(subject, case_name);
  if (answer == nullptr) {
    return {nullptr, fmt::format("there is no answer of the case '{}'", case_name)};
  }
  return {answer, problemWithRecord(*answer)};
}

glm::dvec2 pxAtDistance(const ImageRay& ray, double t_m) {
  // From t_m = sigma * dist_view and 1/dist_view linear in sigma.
  return ray.pxAt(t_m * ray.inv_dist_origin / (1.0 - t_m * ray.inv_dist_per_sigma));
}

// What the bisections left of the step that found a hit at t_m: of a step in metres, or of a stride in pixels
// along the longer axis.
double residualStepPx(const TraceParameters& parameters, const ImageRay& ray, double t_m) {
  const double left = std::exp2(-std::max(0, parameters.bisection_count));
  if (parameters.step_m > 0.0) {
    return glm::length(pxAtDistance(ray, t_m) -
                       pxAtDistance(ray, std::max(0.0, t_m - parameters.step_m * left)));
  }
  const double longer = std::max(std::abs(ray.px_per_sigma.x), std::abs(ray.px_per_sigma.y));
  return parameters.stride_px * left * (longer > 0.0 ? glm::length(ray.px_per_sigma) / longer : 1.0);
}

// Stride 1 is the default of tracers that have none: a step is set by step_m, or by a longer stride in one of
// the cases.
bool setsSteps(const Expectation& expectation, const Subject& subject) {
  bool all_in_metres = true;
  bool any_in_metres = false;
  bool any_stride = false;
  for (const std::string& case_name : expectation.cases) {
    if (const Answer* answer = answerOfCase(subject, case_name)) {
      const bool in_metres = answer->parameters.step_m > 0.0;
      all_in_metres = all_in_metres && in_metres;
      any_in_metres = any_in_metres || in_metres;
      any_stride = any_stride || answer->parameters.stride_px > 1;
    }
  }
  return all_in_metres || (any_stride && !any_in_metres);
}

struct StepErrors {
  std::vector<double> in_steps;  // error over the projected length of the step that found the hit
  std::vector<double> in_px;
};

// One entry for each ray that the oracle hits, off ties; a miss is infinitely wrong.
StepErrors stepErrors(const Answer& answer, const RayPairs& pairs) {
  StepErrors errors;
  const PixelProjection projection = pixelProjection(*answer.oracle_input->camera);
  for (const RayPair& pair : pairs.pairs) {
    if (pair.expected->ray_class != RayClass::kHit) {
      continue;
    }
    double in_px = std::numeric_limits<double>::infinity();
    double in_steps = in_px;
    if (pair.yours->ray_class == RayClass::kHit) {
      const PixelRay pixel = pixelRay(*answer.oracle_input, projection, pair.x, pair.y);
      const double step_px = residualStepPx(answer.parameters, pixel.ray, pair.yours->t_m);
      in_px = std::hypot(static_cast<double>(pair.yours->px_x) - pair.expected->px_x,
                         static_cast<double>(pair.yours->px_y) - pair.expected->px_y);
      in_steps = std::max(0.0, in_px - kRoundingPx) / std::max(step_px, kRoundingPx);
      in_steps = std::isnan(in_steps) ? std::numeric_limits<double>::infinity() : in_steps;
      in_px = std::isnan(in_px) ? std::numeric_limits<double>::infinity() : in_px;
    }
    errors.in_px.push_back(in_px);
    errors.in_steps.push_back(in_steps);
  }
  return errors;
}

}  // namespace

Measurement measureConvergence(const Expectation& expectation, const Subject& subject) {
  Measurement measurement;
  double worst_in_steps = 0.0;
  double previous_px = std::numeric_limits<double>::infinity();
  bool falls = true;
  for (const std::string& case_name : expectation.cases) {
    const auto [answer, problem] = caseAnswer(subject, case_name);
    if (!problem.empty()) {
      return cannotMeasure(problem);
    }
    Subject of_case = subject;
    of_case.self = answer;
    const RayPairs pairs = pairRays(of_case, expectation.truth);
    if (!pairs.problem.empty() || answer->oracle_input == nullptr || !setsSteps(expectation, subject)) {
      return cannotMeasure(
          !pairs.problem.empty()
              ? pairs.problem
              : fmt::format("the case '{}' sets neither step_m nor stride_px, or its oracle input "
                            "is not known",
                            case_name));
    }
    const StepErrors errors = stepErrors(*answer, pairs);
    if (errors.in_px.empty()) {
      continue;
    }
    const double in_steps = percentileOf(errors.in_steps, expectation.percentile);
    const double in_px = percentileOf(errors.in_px, expectation.percentile);
    measurement.compared += errors.in_px.size();
    worst_in_steps = std::max(worst_in_steps, in_steps);
    falls = falls && (in_px < previous_px || in_px <= kRoundingPx);
    previous_px = in_px;
    measurement.remark += fmt::format("{}{}: {:.4g} px, {:.3g} projected steps",
                                      measurement.remark.empty() ? "" : "; ", case_name, in_px, in_steps);
  }
  measurement.value = worst_in_steps;
  if (!falls) {
    measurement.outcome = Outcome::kFail;
    measurement.remark += "; the error does not fall from case to case";
  }
  return measurement;
}

Measurement measureBudgetMonotone(const Expectation& expectation, const Subject& subject) {
  Measurement measurement;
  std::vector<const Answer*> answers;
  for (const std::string& case_name : expectation.cases) {
    const auto [answer, problem] = caseAnswer(subject, case_name);
    if (!problem.empty()) {
      return cannotMeasure(problem);
    }
    if (!answers.empty() && answer->parameters.lookup_budget <= answers.back()->parameters.lookup_budget) {
      return cannotMeasure(fmt::format("the case '{}' does not raise lookup_budget", case_name));
    }
    answers.push_back(answer);
  }
  // A larger budget may only turn BUDGET into an answer; an answer once given stays.
  for (std::size_t i = 1; i < answers.size(); ++i) {
    const RayRecord* small = answers[i - 1]->record;
    const RayRecord* large = answers[i]->record;
    for (int y = 0; y < small->size.height; ++y) {
      for (int x = 0; x < small->size.width; ++x) {
        measurement.compared += hasNoRay(small->at(x, y).ray_class) ? 0U : 1U;
        if (small->at(x, y).ray_class != RayClass::kBudget && !sameAnswer(small->at(x, y), large->at(x, y))) {
          measurement.findings.push_back({x, y, static_cast<double>(answers.size() - i)});
        }
      }
    }
  }
  measurement.value = static_cast<double>(measurement.findings.size());
  measurement.describe = [answers](const Finding& finding) {
    const std::size_t i = answers.size() - static_cast<std::size_t>(finding.severity);
    const auto text = [&](const Answer& answer) {
      const RayHit& ray = answer.record->at(finding.x, finding.y);
      return fmt::format("{} ({}, {}) with budget {}", name(ray.ray_class), ray.texel_x, ray.texel_y,
                         answer.parameters.lookup_budget);
    };
    return FindingText{text(*answers[i]), text(*answers[i - 1]), ""};
  };
  return measurement;
}

}  // namespace ssrkit
