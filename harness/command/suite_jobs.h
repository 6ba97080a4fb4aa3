// The jobs that an expectation file asks for.
#pragma once

#include <string>
#include <vector>

#include "check/expectation.h"
#include "command/suite.h"
#include "frame/job.h"
#include "frame/sequence.h"

namespace ssrkit {

// As many frames as the test says, or as its techniques want.
[[nodiscard]] Sequence sequenceOf(const TestFile& test);

// The variants of its cases, each once, in the order of the cases.
[[nodiscard]] std::vector<std::string> variantsOf(const TestFile& test);
[[nodiscard]] std::vector<TestCase> casesOf(const TestFile& test, const std::string& variant);

// Of rounds that are divided into parts, those of one part: the parts differ by at most one round.
[[nodiscard]] int roundsOfPart(int rounds, int part, int parts);

// One job for all cases of one variant, which share a G-buffer: a trace for each case and stage, in order. It
// is timed over the first part of the test's rounds.
[[nodiscard]] Job jobFor(const TestFile& test, const SceneSource& source, const SuiteOptions& options,
                         Size size, const std::string& variant);

// Whether answers over the test's input are held against those over each device's own G-buffer.
[[nodiscard]] bool comparesWithRendered(const TestFile& test);

// That the variant's worker is driven in.
[[nodiscard]] Environment environmentOf(const std::string& variant);

}  // namespace ssrkit
