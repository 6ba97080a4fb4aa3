// The rays of two records side by side, for every metric that compares them.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "check/measurement.h"
#include "check/subject.h"

namespace ssrkit {

struct RayPair {
  int x = 0;
  int y = 0;
  const RayHit* yours = nullptr;
  const RayHit* expected = nullptr;
};

struct RayPairs {
  std::vector<RayPair>
      pairs;                  // where at least one side traced a ray and the oracle, where known, sees no tie
  std::size_t ambiguous = 0;  // rays left out because the oracle calls them ties
  const RayRecord* expected = nullptr;
  std::string problem;  // why there are none
};

// The subject's record beside the truth's: the oracle's or another answer's.
[[nodiscard]] RayPairs pairRays(const Subject& subject, const Truth& truth);

[[nodiscard]] glm::dvec2 hitPx(const RayHit& hit);

// Same outcome class and same hit texel.
[[nodiscard]] bool sameAnswer(const RayHit& a, const RayHit& b);
[[nodiscard]] bool bothHit(const RayPair& pair);

// Why the subject has no usable record: absent, or not of its own size. Empty when it has one.
[[nodiscard]] std::string problemWithRecord(const Answer& answer);

// Makes the findings of a measurement out of pairs that disagree: value, confusion, description and likely
// cause.
[[nodiscard]] Measurement findingsOf(RayPairs pairs, std::vector<RayPair> differing, const Subject& subject);

}  // namespace ssrkit
