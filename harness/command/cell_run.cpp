#include "command/cell_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "base/check.h"
#include "command/seen_answers.h"

namespace ssrkit {

namespace {

// Loops are cut by Mesa at 65,535 iterations without a word; a ray that comes near has met the limiter.
constexpr std::uint32_t kLimiterSteps = 65000;

// The oracle looks at these alone: cases that differ in other parameters share its answer.
bool sameForOracle(const TraceParameters& a, const TraceParameters& b) {
  return a.thickness_m == b.thickness_m && a.thickness_rel == b.thickness_rel &&
         a.max_distance_m == b.max_distance_m && a.origin_bias == b.origin_bias &&
         a.lookup_budget == b.lookup_budget;
}

std::vector<TimeSample> samplesOf(const PassReport& report) {
  std::vector<TimeSample> samples;
  for (const PassTime& time : report.steady) {
    samples.push_back(
        {.cpu_ns = static_cast<double>(time.cpu_ns), .wall_ns = static_cast<double>(time.wall_ns)});
  }
  return samples;
}

std::string deathText(const WorkerDeath& death) {
  const char* const phase = death.phase == JobPhase::kCompile ? "(compile)"
                            : death.phase == JobPhase::kRun   ? "(run)"
                                                              : "";
  std::string text = death.kind == WorkerDeath::Kind::kTimeout
                         ? fmt::format("timeout{}: the worker was stopped by its time limit (signal {})",
                                       phase, death.signal)
                     : death.signal != 0 ? fmt::format("the worker died of signal {}", death.signal)
                                         : std::string("the worker ended by itself");
  text +=
      fmt::format(" while it was at: {}", death.last_progress.empty() ? "its start" : death.last_progress);
  if (!death.stderr_tail.empty()) {
    text += "\n" + death.stderr_tail;
  }
  return text;
}

}  // namespace

Image maskOf(const std::map<std::string, Image>& images) {
  const auto material = images.find("material");
  Image mask;
  if (material == images.end()) {
    return mask;
  }
  mask = Image(material->second.size, {"mask"});
  for (std::size_t texel = 0; texel < mask.texelCount(); ++texel) {
    mask.data[texel] = material->second.data[texel * material->second.channelCount() + 2];
  }
  return mask;
}

void appendRounds(CellRun& cell, const JobResult& again) {
  const auto append = [](std::vector<PassReport>& passes, const std::vector<PassReport>& more) {
    for (const PassReport& report : more) {
      const auto pass = std::ranges::find(passes, report.pass, &PassReport::pass);
      SSRKIT_CHECK(pass != passes.end());
      pass->steady.insert(pass->steady.end(), report.steady.begin(), report.steady.end());
    }
  };
  SSRKIT_CHECK_EQ(cell.result->traces.size(), again.traces.size());
  append(cell.result->frame_passes, again.frame_passes);
  for (std::size_t i = 0; i < again.traces.size(); ++i) {
    append(cell.result->traces[i].passes, again.traces[i].passes);
  }
}

void addTruths(CellRun& cell) {
  if (!cell.result) {
    return;
  }
  const auto dist_view = cell.result->images.find("dist_view");
  const auto normal_view = cell.result->images.find("normal_view");
  if (dist_view == cell.result->images.end() || normal_view == cell.result->images.end()) {
    return;
  }
  for (std::size_t i = 0; i < cell.result->traces.size(); ++i) {
    const TraceParameters& parameters = cell.result->traces[i].parameters;
    // A technique may have given its tracer depths, normals and a material of its own.
    const std::map<std::string, Image>& own = cell.result->traces[i].images;
    const auto of_trace = [&own](const auto& of_frame) {
      const auto found = own.find(of_frame->first);
      return found != own.end() ? &found->second : &of_frame->second;
    };
    const Image* const depths = of_trace(dist_view);
    const Image* const normals = of_trace(normal_view);
    const Image* mask = &cell.mask;
    if (own.contains("material")) {
      mask = &cell.own_masks.emplace_back(maskOf(own));
    }
    auto truth = std::ranges::find_if(cell.truths, [&](const CellRun::Truth& known) {
      return known.input.dist_view == depths && known.input.normal_view == normals &&
             known.input.mask == mask && sameForOracle(known.input.parameters, parameters);
    });
    if (truth == cell.truths.end()) {
      const OracleInput input{.camera = &cell.result->camera,
                              .dist_view = depths,
                              .normal_view = normals,
                              .mask = mask,
                              .parameters = parameters};
      auto result = traceOracle(input);
      if (!result) {
        cell.error = result.error();
        return;
      }
      cell.truths.push_back({input, std::move(*result), nullptr});
      truth = std::prev(cell.truths.end());
    }
    cell.truth_of_trace[i] = &*truth;
  }
}

void addAnswers(const CellRun& cell, std::vector<Answer>& answers) {
  if (!cell.result || cell.error) {
    return;
  }
  Answer frame{};
  frame.device = cell.device;
  frame.size = cell.result->camera.size;  // that of a crop is smaller than the cell's
  frame.input = cell.input;
  frame.variant = cell.variant;
  frame.is_made = !cell.native_peer.empty();
  frame.shown_in = changesView(cell.variant) ? cell.variant : "";
  frame.frame_cases = cell.cases;
  // The plain frame is all cases'; that of a variant goes by its first case's name.
  frame.case_name = cell.variant.empty() ? "" : cell.cases.front();
  frame.true_dist_view = cell.true_dist_view ? &*cell.true_dist_view : nullptr;
  for (const auto& [name, image] : cell.result->images) {
    frame.images.emplace(name, &image);
  }
  answers.push_back(frame);
  for (std::size_t i = 0; i < cell.result->traces.size(); ++i) {
    const TraceResult& trace = cell.result->traces[i];
    Answer answer = frame;
    answer.stage = trace.stage;
    answer.case_name = cell.case_of_trace[i];
    answer.parameters = trace.parameters;
    answer.record = &trace.record;
    if (const CellRun::Truth* truth = cell.truth_of_trace[i]) {
      answer.oracle_input = &truth->input;
      answer.oracle = &truth->result;
      answer.geometry = truth->geometry;
    }
    for (const auto& [name, image] : trace.images) {
      answer.images.insert_or_assign(name, &image);
    }
    for (const auto& passes : {cell.result->frame_passes, trace.passes}) {
      for (const PassReport& report : passes) {
        answer.times.emplace(report.pass, samplesOf(report));
      }
    }
    answers.push_back(std::move(answer));
  }
}

CheckResult failureOf(const CellRun& cell) {
  CheckResult result;
  result.device = cell.device;
  result.size = cell.size;
  result.outcome = Outcome::kError;
  if (cell.error) {
    result.message = sentence(*cell.error);
  } else if (cell.death) {
    const bool is_timeout = cell.death->kind == WorkerDeath::Kind::kTimeout;
    result.outcome = is_timeout ? Outcome::kTimeout : Outcome::kCrash;
    result.message = deathText(*cell.death);
  }
  return result;
}

std::vector<CheckResult> messagesOf(const CellRun& cell) {
  std::vector<CheckResult> checks;
  for (const std::string& message : cell.result->messages) {
    CheckResult& check = checks.emplace_back(failureOf(cell));
    check.outcome = Outcome::kFail;
    check.message = message;
  }
  return checks;
}

std::vector<CheckResult> limitedTracesOf(const CellRun& cell) {
  std::vector<CheckResult> checks;
  for (const TraceResult& trace : cell.result->traces) {
    const bool is_cut = std::ranges::any_of(trace.record.rays, [](const RayHit& ray) {
      return std::max(ray.steps, ray.lookups) >= kLimiterSteps;
    });
    if (is_cut) {
      CheckResult& check = checks.emplace_back(failureOf(cell));
      check.stage = trace.stage;
      check.outcome = Outcome::kLimiter;
      check.message = fmt::format(
          "a ray took {} steps or more: Mesa cuts loops at 65,535 iterations without a word, so the answer "
          "is not the "
          "shader's own; bound the loop",
          kLimiterSteps);
    }
  }
  return checks;
}

void shareTimes(const std::deque<CellRun>& cells, std::vector<CheckResult>& checks) {
  std::map<std::string, double> time_s;
  for (const CellRun& cell : cells) {
    time_s[cell.device] += cell.time_s;
  }
  for (CheckResult& check : checks) {
    const auto sharing = std::ranges::count(checks, check.device, &CheckResult::device);
    check.time_s = time_s[check.device] / static_cast<double>(sharing);
  }
}

}  // namespace ssrkit
