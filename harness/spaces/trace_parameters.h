// The parameters of the tracing contract: the same names in --param, TOML and JSON, for the tracers and the
// oracle.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"

namespace ssrkit {

// The greatest step_count; a step along the 3-D ray is at least the ray's length over this (ssr_step.glsl).
inline constexpr int kMaxStepCount = 16384;

enum class TracerForm { kTextbook, kTuned };

// Names and values of parameters, as setParameter reads them.
using ParameterList = std::vector<std::pair<std::string, std::string>>;

struct TraceParameters {
  double thickness_m = std::numeric_limits<double>::infinity();  // depth of every texel's column
  double thickness_rel = 0.0;                                    // added to it, as a fraction of dist_view
  double max_distance_m = std::numeric_limits<double>::infinity();
  double origin_bias = 0.0;   // along the normal, as a fraction of dist_view
  int lookup_budget = 60000;  // the default never binds
  int step_count = 0;   // steps over the clipped ray; capped: the most samples; 0: the stage's own default
  double step_m = 0.0;  // length of a step along the 3-D ray, or of the first; 0: taken from step_count
  int bisection_count = -1;  // halvings of the step that found the hit; -1: the stage's own default
  int stride_px = 1;         // dda, homogeneous, capped: from sample to sample
  double jitter = 0.0;       // 0..1 of a step or stride
  int max_mip = -1;          // hiz: coarsest level it climbs to; -1: the stage's own default
  double step_growth = 1.0;  // exponential, adaptive: a step's length over that of the one before
  TracerForm form = TracerForm::kTuned;  // hiz

  bool operator==(const TraceParameters&) const = default;
};

// Sets one parameter from text ("thickness_m", "0.3"). Fails on unknown names (with the nearest one), on
// values that are no numbers, and on values outside the parameter's range. `where` names the file or option.
[[nodiscard]] Expected<void> setParameter(TraceParameters& parameters, std::string_view name,
                                          std::string_view value, const std::string& where);

// Whether parameters that are written together (one file, one [[case]], all --param of a command) give a
// thickness_rel over 0 and no thickness_m. The thickness is then relative alone, thickness_rel * dist_view:
// whoever reads them sets thickness_m to 0, whatever it was.
[[nodiscard]] bool isThicknessRelativeAlone(const ParameterList& written);

// Every parameter's name, in the order of the struct.
[[nodiscard]] std::span<const std::string> parameterNames();

// The value of one parameter as text that setParameter reads back: "inf", "0.3", "textbook".
[[nodiscard]] std::string parameterText(const TraceParameters& parameters, std::string_view name);

}  // namespace ssrkit
