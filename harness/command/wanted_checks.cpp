#include "command/wanted_checks.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "command/kit_paths.h"
#include "oracle/closed_form.h"
#include "scene/find_scene.h"

namespace ssrkit {

namespace {

// The steps that each stage takes by itself.
bool hasOwnSteps(const TraceParameters& parameters) {
  const TraceParameters own;
  return parameters.step_count == own.step_count && parameters.step_m == own.step_m &&
         parameters.bisection_count == own.bisection_count && parameters.stride_px == own.stride_px &&
         parameters.jitter == own.jitter && parameters.step_growth == own.step_growth;
}

// The formulas are those of whole rays from their pixels' own points.
bool keepsWholeRays(const std::string& assignment) {
  const std::string parameter = assignment.substr(0, assignment.find('='));
  return parameter != "max_distance_m" && parameter != "origin_bias" && parameter != "lookup_budget";
}

// Of the built-in scene itself, and of its plain rays: a file of the user's may bear its name.
bool hasFormula(const SceneSource& source, const RunOptions& options) {
  const auto built_in = findScene(source.name, kitPaths().scenes);
  std::error_code ignored;
  return findClosedForm(source.name) != nullptr && source.gbuffer == nullptr && options.camera.empty() &&
         options.mirror.empty() && options.techniques.empty() &&
         std::ranges::all_of(options.parameters, keepsWholeRays) && built_in &&
         std::filesystem::equivalent(*built_in, source.file, ignored);
}

}  // namespace

void keepWhatIsAsked(TestFile& test, const SceneSource& source, const RunOptions& options) {
  const TraceParameters& parameters = source.defaults;
  const bool is_dense = parameters.stride_px == 1 && parameters.jitter == 0.0;
  const bool is_unlimited = parameters.lookup_budget == TraceParameters{}.lookup_budget;
  const bool steps_as_set = is_unlimited && hasOwnSteps(parameters);
  const bool has_formula = hasFormula(source, options);
  std::erase_if(test.expectations, [&](Expectation& expectation) {
    const bool against_oracle = expectation.truth.kind == TruthKind::kOracle;
    const bool of_steps =
        expectation.metric == Metric::kHitInStepShare || expectation.metric == Metric::kHitOffRayShare;
    std::erase_if(expectation.stages, [&](const std::string& stage) {
      const bool is_chosen = std::ranges::find(test.stages, stage) != test.stages.end();
      return !is_chosen || (of_steps && !steps_as_set) ||
             (against_oracle && stage == "dda" && !(is_dense && is_unlimited)) ||
             (against_oracle && stage == "hiz" && !is_unlimited);
    });
    const bool lacks_formula = expectation.truth.kind == TruthKind::kClosedForm && !has_formula;
    return expectation.stages.empty() || lacks_formula;
  });
}

}  // namespace ssrkit
