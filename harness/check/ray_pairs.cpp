#include "check/ray_pairs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "base/check.h"
#include "base/size.h"
#include "check/signatures.h"

namespace ssrkit {

namespace {

std::string answerText(const RayHit& hit) {
  if (hit.ray_class != RayClass::kHit) {
    return name(hit.ray_class);
  }
  return fmt::format("HIT ({}, {})", hit.texel_x, hit.texel_y);
}

std::string deltaText(const RayPair& pair) {
  if (!bothHit(pair)) {
    return "class";
  }
  return fmt::format("({:+}, {:+}) px", pair.yours->texel_x - pair.expected->texel_x,
                     pair.yours->texel_y - pair.expected->texel_y);
}

// Differences of class first, then the largest distances.
double severityOf(const RayPair& pair) {
  if (!bothHit(pair)) {
    return std::numeric_limits<double>::infinity();
  }
  return std::hypot(pair.yours->texel_x - pair.expected->texel_x,
                    pair.yours->texel_y - pair.expected->texel_y);
}

struct ExpectedRecord {
  const RayRecord* record = nullptr;
  std::string problem;
};

ExpectedRecord expectedRecord(const Subject& subject, const Truth& truth) {
  if (truth.kind == TruthKind::kOracle) {
    if (subject.self->oracle == nullptr) {
      return {nullptr, "the oracle was not traced over the depth image that this stage read"};
    }
    return {&subject.self->oracle->record, ""};
  }
  const auto answer = answerOfTruth(subject, truth);
  if (const auto* problem = std::get_if<std::string>(&answer)) {
    return {nullptr, *problem};
  }
  const Answer& other = *std::get<const Answer*>(answer);
  return {other.record, problemWithRecord(other)};
}

}  // namespace

glm::dvec2 hitPx(const RayHit& hit) {
  return {hit.px_x, hit.px_y};
}

bool sameAnswer(const RayHit& a, const RayHit& b) {
  return a.ray_class == b.ray_class && a.texel_x == b.texel_x && a.texel_y == b.texel_y;
}

bool bothHit(const RayPair& pair) {
  return pair.yours->ray_class == RayClass::kHit && pair.expected->ray_class == RayClass::kHit;
}

std::string problemWithRecord(const Answer& answer) {
  if (answer.record == nullptr) {
    return fmt::format("the stage '{}' left no record on {}", answer.stage, answer.device);
  }
  const RayRecord& record = *answer.record;
  const auto expected_count =
      static_cast<std::size_t>(answer.size.width) * static_cast<std::size_t>(answer.size.height);
  if (record.size != answer.size || record.rays.size() != expected_count) {
    return fmt::format("the record of the stage '{}' on {} is {}, not {}", answer.stage, answer.device,
                       sizeText(record.size), sizeText(answer.size));
  }
  return {};
}

RayPairs pairRays(const Subject& subject, const Truth& truth) {
  RayPairs result;
  result.problem = problemWithRecord(*subject.self);
  if (!result.problem.empty()) {
    return result;
  }
  const ExpectedRecord expected = expectedRecord(subject, truth);
  if (!expected.problem.empty()) {
    result.problem = expected.problem;
    return result;
  }
  SSRKIT_CHECK(expected.record != nullptr);
  const RayRecord& yours = *subject.self->record;
  if (expected.record->rays.size() != yours.rays.size()) {
    result.problem = fmt::format("the records have different sizes, {} and {}", sizeText(yours.size),
                                 sizeText(expected.record->size));
  }
  const OracleResult* oracle = subject.self->oracle;
  if (result.problem.empty() && oracle != nullptr && oracle->ambiguity.size() != yours.rays.size()) {
    result.problem = "the oracle's list of ties does not have the record's size";
  }
  if (!result.problem.empty()) {
    return result;
  }
  result.expected = expected.record;
  // Grown bit by bit, they would be there twice. What is not filled takes no memory.
  result.pairs.reserve(yours.rays.size());
  for (int y = 0; y < yours.size.height; ++y) {
    for (int x = 0; x < yours.size.width; ++x) {
      const RayPair pair{x, y, &yours.at(x, y), &expected.record->at(x, y)};
      if (hasNoRay(pair.yours->ray_class) && hasNoRay(pair.expected->ray_class) &&
          sameAnswer(*pair.yours, *pair.expected)) {
        continue;
      }
      const auto index = static_cast<std::size_t>(pair.yours - yours.rays.data());
      if (oracle != nullptr && oracle->ambiguity[index] != Ambiguity::kNone) {
        ++result.ambiguous;
        continue;
      }
      result.pairs.push_back(pair);
    }
  }
  return result;
}

Measurement findingsOf(RayPairs pairs, std::vector<RayPair> differing, const Subject& subject) {
  Measurement measurement;
  measurement.compared = pairs.pairs.size();
  if (pairs.ambiguous > 0) {
    measurement.remark =
        fmt::format("{} rays are ties in single precision and were left out", pairs.ambiguous);
  }
  for (const RayPair& pair : differing) {
    measurement.findings.push_back({pair.x, pair.y, severityOf(pair)});
    ++measurement.confusion[{pair.expected->ray_class, pair.yours->ray_class}];
  }
  const RayRecord* yours = subject.self->record;
  const RayRecord* expected = pairs.expected;
  measurement.describe = [yours, expected](const Finding& finding) {
    const RayPair pair{finding.x, finding.y, &yours->at(finding.x, finding.y),
                       &expected->at(finding.x, finding.y)};
    return FindingText{answerText(*pair.yours), answerText(*pair.expected), deltaText(pair)};
  };
  auto all = std::make_shared<const std::vector<RayPair>>(std::move(pairs.pairs));
  auto wrong = std::make_shared<const std::vector<RayPair>>(std::move(differing));
  const Answer* self = subject.self;
  measurement.cause = [all, wrong, self] { return likelyCause(SignatureInput{*all, *wrong, *self}); };
  return measurement;
}

}  // namespace ssrkit
