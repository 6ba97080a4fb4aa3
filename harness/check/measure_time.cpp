#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "check/measure.h"
#include "check/paired_ratio.h"
#include "check/percentile.h"

namespace ssrkit {

namespace {

struct CpuRounds {
  std::vector<double> cpu_ns;  // summed over the passes, one a round
  std::string problem;
};

// In the place of a list of passes: every pass of the frame and of the trace.
constexpr const char* kAllPasses = "all";

std::vector<std::string> timedPasses(const Answer& answer) {
  std::vector<std::string> passes;
  for (const auto& [pass, samples] : answer.times) {
    passes.push_back(pass);
  }
  return passes;
}

CpuRounds cpuOf(const Answer& answer, const std::vector<std::string>& named) {
  const std::vector<std::string> passes =
      named == std::vector<std::string>{kAllPasses} ? timedPasses(answer) : named;
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

// The pass with the largest median that is not among `passes`; empty when there is no other.
std::string costliestOther(const Answer& answer, const std::vector<std::string>& passes) {
  constexpr double kMedian = 50.0;
  std::string costliest;
  double most = 0.0;
  for (const std::string& pass : timedPasses(answer)) {
    const CpuRounds rounds = cpuOf(answer, {pass});
    const bool is_other = std::ranges::find(passes, pass) == passes.end();
    if (is_other && !rounds.cpu_ns.empty() && percentileOf(rounds.cpu_ns, kMedian) > most) {
      most = percentileOf(rounds.cpu_ns, kMedian);
      costliest = pass;
    }
  }
  return costliest;
}

// The ratio of the rounds of one cost to those of another, held to the expectation's bounds.
Measurement ratioOf(const CpuRounds& yours, const CpuRounds& other, const Expectation& expectation) {
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
  measurement.interval = {ratio->low, ratio->high};
  measurement.outcome = judgeRatio(*ratio, expectation.min, expectation.max, expectation.margin);
  measurement.remark = fmt::format("median of {} interleaved rounds {:.4g}, 99 % interval {:.4g} to {:.4g}",
                                   yours.cpu_ns.size(), ratio->median, ratio->low, ratio->high);
  return measurement;
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
  std::vector<std::string> over = expectation.over.empty() ? expectation.passes : expectation.over;
  const bool is_lead = expectation.metric == Metric::kPassCpuLead;
  if (is_lead) {
    over = {costliestOther(*subject.self, expectation.passes)};
    if (over.front().empty()) {
      return cannotMeasure("no other pass was timed");
    }
  }
  Measurement measurement =
      ratioOf(cpuOf(*subject.self, expectation.passes), cpuOf(*below, over), expectation);
  measurement.remark += is_lead && measurement.value ? fmt::format(", over '{}'", over.front()) : "";
  return measurement;
}

}  // namespace ssrkit
