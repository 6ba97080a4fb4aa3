// What a metric found out, before it is held to its bounds.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "check/check_result.h"
#include "check/outcome.h"
#include "image/ray_record.h"

namespace ssrkit {

// A texel that is not as it should be.
struct Finding {
  int x = 0;
  int y = 0;
  double severity = 0.0;  // larger is worse, for the order in which findings are shown
};

// One row of the table that a failure shows.
struct FindingText {
  std::string yours;
  std::string expected;
  std::string delta;
};

struct Measurement {
  std::optional<double> value;
  std::optional<std::pair<double, double>>
      interval;                         // holds the true value with 99 % probability, where noise is known
  std::vector<HistogramBin> histogram;  // where the value is one of a distribution
  std::size_t compared = 0;             // rays or pixels that had a say
  std::string compared_what = "rays";   // or "pixels", "rounds"
  std::string problem;                  // why it could not be measured: outcome error
  std::string remark;                   // a line for the message, whatever the outcome
  std::optional<Outcome> outcome;       // where the bounds alone do not decide
  std::vector<Finding> findings;        // every texel that counts against the subject
  std::map<std::pair<RayClass, RayClass>, std::size_t> confusion;  // of the findings: expected, yours
  std::function<FindingText(const Finding&)> describe;             // called for the findings that are shown
  std::function<std::optional<std::string>()> cause;               // called on failure
};

[[nodiscard]] inline Measurement cannotMeasure(std::string problem) {
  Measurement measurement;
  measurement.problem = std::move(problem);
  return measurement;
}

}  // namespace ssrkit
