#include "command/extra_passes.h"

#include <fmt/format.h>

#include <cstring>

#include "check/ray_bits.h"
#include "shader/module_variants.h"

namespace ssrkit {

namespace {

// What differs between two drawings of one job.
struct Difference {
  std::size_t texels = 0;
  std::size_t compared = 0;
  std::string first;  // "the rays of hiz", "the image lit"; empty where all is alike
};

void add(Difference& difference, std::size_t differing, std::size_t compared, const std::string& what) {
  difference.texels += differing;
  difference.compared += compared;
  if (differing > 0 && difference.first.empty()) {
    difference.first = what;
  }
}

void compareImages(Difference& difference, const std::map<std::string, Image>& a,
                   const std::map<std::string, Image>& b, const std::string& of) {
  for (const auto& [name, image] : a) {
    const auto other = b.find(name);
    const bool comparable = other != b.end() && other->second.data.size() == image.data.size();
    std::size_t differing = comparable ? 0 : image.texelCount();
    for (std::size_t texel = 0; comparable && texel < image.texelCount(); ++texel) {
      const std::size_t first = texel * image.channelCount();
      const std::size_t bytes = image.channelCount() * sizeof(float);
      differing += std::memcmp(&image.data[first], &other->second.data[first], bytes) == 0 ? 0 : 1;
    }
    add(difference, differing, image.texelCount(), fmt::format("the image {}{}", name, of));
  }
}

Difference differenceOf(const JobResult& a, const JobResult& b) {
  Difference difference;
  compareImages(difference, a.images, b.images, "");
  // What the second drawing lacks is different.
  for (std::size_t i = 0; i < a.traces.size(); ++i) {
    const TraceResult none;
    const TraceResult& trace = a.traces[i];
    const TraceResult& other = i < b.traces.size() ? b.traces[i] : none;
    std::size_t differing = 0;
    for (std::size_t ray = 0; ray < trace.record.rays.size(); ++ray) {
      const bool is_there = ray < other.record.rays.size();
      const bool same = is_there && differingFields(trace.record.rays[ray], other.record.rays[ray]).empty();
      differing += same ? 0 : 1;
    }
    add(difference, differing, trace.record.rays.size(), "the rays of " + trace.stage);
    compareImages(difference, trace.images, other.images, " of " + trace.stage);
  }
  return difference;
}

CheckResult resultOf(const CellRun& cell, Outcome outcome, std::string message) {
  CheckResult result;
  result.device = cell.device;
  result.size = cell.size;
  result.outcome = outcome;
  result.message = std::move(message);
  return result;
}

// A pass that says how much differs; what a difference means is the caller's to say.
CheckResult resultOf(const CellRun& cell, const Difference& difference) {
  CheckResult result = resultOf(cell, Outcome::kPass, "");
  result.compared = difference.compared;
  result.value = static_cast<double>(difference.texels);
  result.unit = "texels";
  return result;
}

// Why the second drawing has no answer.
CheckResult noAnswer(const CellRun& cell, const JobOutcome& outcome) {
  CellRun other;
  other.device = cell.device;
  other.size = cell.size;
  if (const auto* const error = std::get_if<Error>(&outcome)) {
    other.error = *error;
  } else {
    other.death = std::get<WorkerDeath>(outcome);
  }
  return failureOf(other);
}

}  // namespace

std::optional<CheckResult> outOfBoundsCheck(const CellRun& cell, const JobOutcome& clamped) {
  const auto* const result = std::get_if<JobResult>(&clamped);
  if (cell.death && result != nullptr && cell.death->kind == WorkerDeath::Kind::kCrash) {
    return resultOf(
        cell, Outcome::kFail,
        fmt::format("a shader reads or writes outside: the worker died at '{}', and does not once "
                    "every index is clamped to its array",
                    cell.death->last_progress));
  }
  if (!cell.result) {
    return std::nullopt;
  }
  if (result == nullptr) {
    return noAnswer(cell, clamped);
  }
  const Difference difference = differenceOf(*cell.result, *result);
  CheckResult check = resultOf(cell, difference);
  if (difference.texels > 0) {
    check.outcome = Outcome::kFail;
    check.message = fmt::format(
        "a shader reads or writes outside an array: {} texels differ once every index is clamped, the first "
        "of them in {}",
        difference.texels, difference.first);
  }
  return check;
}

std::optional<CheckResult> loopCheck(const CellRun& cell, const JobOutcome& counted) {
  const auto* const result = std::get_if<JobResult>(&counted);
  if (!cell.result) {
    return std::nullopt;
  }
  if (result == nullptr) {
    return noAnswer(cell, counted);
  }
  const Difference difference = differenceOf(*cell.result, *result);
  CheckResult check = resultOf(cell, difference);
  if (difference.texels > 0) {
    check.outcome = Outcome::kLimiter;
    check.message = fmt::format(
        "{} texels, the first of them in {}, are of fragments whose loops run more than {} times: Mesa cuts "
        "loops at 65,535 iterations without a word, so the answer may not be the shader's own; bound the "
        "loop",
        difference.texels, difference.first, kCountedLoopLimit);
  }
  return check;
}

std::vector<CheckResult> validationChecks(const CellRun& cell, const JobOutcome& validated) {
  const auto* const result = std::get_if<JobResult>(&validated);
  if (result == nullptr) {
    return {noAnswer(cell, validated)};
  }
  std::vector<CheckResult> checks;
  for (const std::string& message : result->messages) {
    checks.push_back(resultOf(cell, Outcome::kFail, message));
  }
  if (checks.empty()) {
    checks.push_back(resultOf(cell, Outcome::kPass, ""));
  }
  return checks;
}

std::vector<CheckResult> extraChecks(const CellRun& cell, const ExtraPasses& passes,
                                     const DeviceConcerns& device, const DrawAgain& again) {
  std::vector<CheckResult> checks;
  const auto keep = [&checks](CheckResult check, const std::string& name) {
    check.metric = name;
    checks.push_back(std::move(check));
  };
  // What hung would hang again.
  const bool has_crashed = cell.death && cell.death->kind == WorkerDeath::Kind::kCrash;
  if (passes.safety && (cell.result || has_crashed)) {
    if (auto check = outOfBoundsCheck(cell, again("robust", {}))) {
      keep(std::move(*check), "out_of_bounds");
    }
  }
  if (passes.safety && cell.result && device.cuts_loops) {
    if (auto check = loopCheck(cell, again("counted_loops", {}))) {
      keep(std::move(*check), "counted_loops");
    }
  }
  if (!passes.validate.empty() && device.is_vulkan) {
    for (CheckResult& check : validationChecks(cell, again("", {{"SSRKIT_VALIDATION", passes.validate}}))) {
      keep(std::move(check), "validation");
    }
  }
  return checks;
}

}  // namespace ssrkit
