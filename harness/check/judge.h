// A whole test against everything that a run collected of one scene.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "check/check_result.h"
#include "check/expectation.h"
#include "check/subject.h"

namespace ssrkit {

// Whether `expectation` of `test` is asked of `answer`: its stage, case, size and input are among those
// named, and it is not the truth itself. Metrics over cases are asked once, of the first case's answer.
[[nodiscard]] bool isAskedOf(const TestFile& test, const Expectation& expectation, const Answer& answer);

// What the truth `golden` of an expectation is for an answer; null where nobody has blessed one that fits.
using GoldenLookup = std::function<const Answer*(const Expectation& expectation, const Answer& answer)>;

// One result for each expectation and answer it is asked of, in the order of the file. An expectation that no
// answer fits gives one result with the outcome `missing`. `repro` gives the command that runs the check of
// an answer again.
[[nodiscard]] std::vector<CheckResult> judge(const TestFile& test, const std::string& scene,
                                             std::span<const Answer> answers,
                                             const std::function<std::string(const Answer&)>& repro,
                                             const GoldenLookup& golden = {});

}  // namespace ssrkit
