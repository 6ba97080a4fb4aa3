#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "check/measure.h"
#include "check/paired_ratio.h"
#include "check/percentile.h"
#include "spaces/roofline.h"

namespace ssrkit {

namespace {

struct TimedRounds {
  std::vector<double> ns;  // summed over the passes, one a round
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

using Clock = double TimeSample::*;

TimedRounds roundsOf(const Answer& answer, const std::vector<std::string>& named, Clock clock) {
  const std::vector<std::string> passes =
      named == std::vector<std::string>{kAllPasses} ? timedPasses(answer) : named;
  TimedRounds rounds;
  for (const std::string& pass : passes) {
    const auto found = answer.times.find(pass);
    if (found == answer.times.end() || found->second.empty()) {
      rounds.problem = fmt::format("the pass '{}' of the stage '{}' was not timed", pass, answer.stage);
      return rounds;
    }
    rounds.ns.resize(rounds.ns.empty() ? found->second.size() : rounds.ns.size());
    if (found->second.size() != rounds.ns.size()) {
      rounds.problem = fmt::format("the pass '{}' of the stage '{}' has {} timed rounds, not {}", pass,
                                   answer.stage, found->second.size(), rounds.ns.size());
      return rounds;
    }
    for (std::size_t round = 0; round < rounds.ns.size(); ++round) {
      rounds.ns[round] += found->second[round].*clock;
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
    const TimedRounds rounds = roundsOf(answer, {pass}, &TimeSample::cpu_ns);
    const bool is_other = std::ranges::find(passes, pass) == passes.end();
    if (is_other && !rounds.ns.empty() && percentileOf(rounds.ns, kMedian) > most) {
      most = percentileOf(rounds.ns, kMedian);
      costliest = pass;
    }
  }
  return costliest;
}

void scale(TimedRounds& rounds, double factor) {
  for (double& ns : rounds.ns) {
    ns *= factor;
  }
}

double pixelCount(const Answer& answer) {
  return static_cast<double>(answer.size.width) * static_cast<double>(answer.size.height);
}

// The ratio of the rounds of one cost to those of another, held to the expectation's bounds.
Measurement ratioOf(const TimedRounds& yours, const TimedRounds& other, const Expectation& expectation) {
  for (const TimedRounds* side : {&yours, &other}) {
    if (!side->problem.empty()) {
      return cannotMeasure(side->problem);
    }
  }
  if (yours.ns.size() != other.ns.size()) {
    return cannotMeasure(fmt::format("{} rounds cannot be paired with {}", yours.ns.size(), other.ns.size()));
  }
  Measurement measurement;
  measurement.compared = yours.ns.size();
  measurement.compared_what = "rounds";
  const std::optional<RatioInterval> ratio = pairedRatio(yours.ns, other.ns);
  if (!ratio) {
    measurement.outcome = Outcome::kInconclusive;
    measurement.remark = "fewer than 8 rounds, or a round without measurable CPU time, cannot settle a ratio";
    return measurement;
  }
  measurement.value = ratio->median;
  measurement.interval = {ratio->low, ratio->high};
  measurement.outcome = judgeRatio(*ratio, expectation.min, expectation.max, expectation.margin);
  measurement.remark = fmt::format("median of {} interleaved rounds {:.4g}, 99 % interval {:.4g} to {:.4g}",
                                   yours.ns.size(), ratio->median, ratio->low, ratio->high);
  return measurement;
}

}  // namespace

Measurement measureCpuRatio(const Expectation& expectation, const Subject& subject) {
  const Answer* below = subject.self;
  if (expectation.truth.kind != TruthKind::kNone) {
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
  const Clock clock = expectation.metric == Metric::kWallRatio ? &TimeSample::wall_ns : &TimeSample::cpu_ns;
  TimedRounds yours = roundsOf(*subject.self, expectation.passes, clock);
  TimedRounds other = roundsOf(*below, over, clock);
  if (expectation.metric == Metric::kPixelCpuRatio) {
    scale(yours, 1.0 / pixelCount(*subject.self));
    scale(other, 1.0 / pixelCount(*below));
  }
  Measurement measurement = ratioOf(yours, other, expectation);
  measurement.remark += is_lead && measurement.value ? fmt::format(", over '{}'", over.front()) : "";
  return measurement;
}

Measurement measureRooflineMultiple(const Expectation& expectation, const Subject& subject) {
  const Answer& self = *subject.self;
  if (self.record == nullptr) {
    return cannotMeasure("the stage has no ray record");
  }
  double lookups = 0.0;
  for (const RayHit& ray : self.record->rays) {
    lookups += ray.lookups;
  }
  // Round by round: what the trace's lookups would take as nothing but fetches that wait for each other, and
  // its pixels as nothing but writes.
  TimedRounds limit = roundsOf(self, {"bench_dependent_fetch"}, &TimeSample::cpu_ns);
  const TimedRounds writes = roundsOf(self, {"bench_write"}, &TimeSample::cpu_ns);
  if (!limit.problem.empty() || !writes.problem.empty()) {
    return cannotMeasure("the rooflines were not timed: the case needs technique = \"rooflines\"");
  }
  scale(limit, lookups / (kRooflineFetchCount * pixelCount(self)));
  for (std::size_t round = 0; round < limit.ns.size(); ++round) {
    limit.ns[round] += writes.ns[round];
  }
  return ratioOf(roundsOf(self, {"trace"}, &TimeSample::cpu_ns), limit, expectation);
}

}  // namespace ssrkit
