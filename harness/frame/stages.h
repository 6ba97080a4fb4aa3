// The tracers, as rows of data: add a stage by adding a row and its shader.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/size.h"
#include "spaces/trace_parameters.h"

namespace ssrkit {

struct Stage {
  std::string name;            // "hiz"
  std::string about;           // one line for people
  std::string shader;          // entry file of the textbook form, under shaders/
  std::string tuned_shader;    // the same for form = tuned; equal where there is one form only
  int default_step_count = 0;  // over the clipped ray; 0: the stage takes no steps of equal length
  int default_bisections = 0;
  int default_max_mip = 0;
  ParameterList
      preset;  // what makes the row a variant; over the scene's values, under a case's and --param's
};

// Every stage, "naive" first, the yardstick "walk" last.
[[nodiscard]] std::span<const Stage> stages();

// Fails with the nearest name and the list.
[[nodiscard]] Expected<const Stage*> findStage(std::string_view name);

// What a trace is asked for: the scene's parameters, then the row's preset, then what was chosen by hand (a
// case's or --param's, checked when it was read).
[[nodiscard]] TraceParameters askedParameters(const TraceParameters& scene, const Stage& stage,
                                              const ParameterList& chosen);

// The first of `step_count` steps, each `growth` times as long as the one before, as a share of their sum.
[[nodiscard]] double firstStepShare(double growth, int step_count);

// `parameters` with the stage's defaults in the place of what was left open, and max_mip no higher than an
// image of `size` has levels.
[[nodiscard]] TraceParameters withStageDefaults(const TraceParameters& parameters, const Stage& stage,
                                                Size size);

// The entry file that the parameters' form asks for.
[[nodiscard]] const std::string& shaderOf(const Stage& stage, const TraceParameters& parameters);

}  // namespace ssrkit
