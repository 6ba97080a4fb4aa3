#include <fmt/format.h>

#include "base/text.h"
#include "check/measure.h"
#include "check/paired_ratio.h"

namespace ssrkit {

namespace {

struct CpuRounds {
  std::vector<double> cpu_ns;  // summed over the passes, one a round
  std::string problem;
};

CpuRounds cpuOf(const Answer& answer, const std::vector<std::string>& passes) {
  CpuRounds rounds;
  for (const std::string& pass : passes) {
    const auto found = answer.times.find(pass);
    if (found == answer.times.end() || found->second.empty()) {
      rounds.problem = fmt::format("the pass '{}' of the stage '{}' was not timed", pass, answer.stage);
      return rounds;
    }
    rounds.cpu_ns.resize(rounds.cpu_ns.empty() ? found->second.size() : rounds.cpu_ns.size());
    if (found->second.size() != rounds.cpu_ns.size()) {
      rounds.problem = fmt::format("the pass '{}' of the stage '{}' has {} timed rounds, not {}", pass,
                                   answer.stage, found->second.size(), rounds.cpu_ns.size());
      return rounds;
    }
    for (std::size_t round = 0; round < rounds.cpu_ns.size(); ++round) {
      rounds.cpu_ns[round] += found->second[round].cpu_ns;
    }
  }
  return rounds;
}

}  // namespace

Measurement measureCpuRatio(const Expectation& expectation, const Subject& subject) {
  const Answer* below = subject.self;
  if (expectation.metric == Metric::kCpuRatio) {
    const auto answer = answerOfTruth(subject, expectation.truth);
    if (const auto* problem = std::get_if<std::string>(&answer)) {
      return cannotMeasure(*problem);
    }
    below = std::get<const Answer*>(answer);
  }
  const CpuRounds yours = cpuOf(*subject.self, expectation.passes);
  const CpuRounds other = cpuOf(*below, expectation.over.empty() ? expectation.passes : expectation.over);
  for (const CpuRounds* side : {&yours, &other}) {
    if (!side->problem.empty()) {
      return cannotMeasure(side->problem);
    }
  }
  if (yours.cpu_ns.size() != other.cpu_ns.size()) {
    return cannotMeasure(
        fmt::format("{} rounds cannot be paired with {}", yours.cpu_ns.size(), other.cpu_ns.size()));
  }
  Measurement measurement;
  measurement.compared = yours.cpu_ns.size();
  measurement.compared_what = "rounds";
  const std::optional<RatioInterval> ratio = pairedRatio(yours.cpu_ns, other.cpu_ns);
  if (!ratio) {
    measurement.outcome = Outcome::kInconclusive;
    measurement.remark = "fewer than 8 rounds, or a round without measurable CPU time, cannot settle a ratio";
    return measurement;
  }
  measurement.value = ratio->median;
  measurement.outcome = judgeRatio(*ratio, expectation.min, expectation.max, expectation.margin);
  measurement.remark = fmt::format("median of {} interleaved rounds {:.4g}, 99 % interval {:.4g} to {:.4g}",
                                   yours.cpu_ns.size(), ratio->median, ratio->low, ratio->high);
  return measurement;
}

}  // namespace ssrkit
