// A claim about screen-space reflections as an experiment: the content of one file of tests/claims/
// (docs/claims.md). Its test is run as any other; what comes out confirms or refutes it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "check/expectation.h"

namespace ssrkit {

enum class ClaimVerdict : std::uint8_t {
  kConfirmed,
  kInconclusive,  // between what confirms and what refutes, or the noise is larger than what there is to tell
                  // apart
  kRefuted,
  kNotMeasured,  // a crash, a missing answer: nothing is known of the claim
};

[[nodiscard]] const char* name(ClaimVerdict verdict);  // "refuted"
[[nodiscard]] std::optional<ClaimVerdict> claimVerdictFromName(std::string_view verdict_name);

// What refutes one figure: a value at or above, or at or below. Its expectation's bounds confirm it.
struct RefutingBounds {
  std::optional<double> above;
  std::optional<double> below;
};

struct Claim {
  std::string name;          // the test's id
  std::string source;        // who says so, and when
  std::string says;          // in this kit's words
  std::string if_confirmed;  // what it means, or why; may be empty
  std::string if_refuted;
  ClaimVerdict finding = ClaimVerdict::kConfirmed;  // of whoever wrote the file down
  TestFile test;                                    // `about` is the hypothesis
  std::vector<RefutingBounds> refuting;             // one for each of the test's expectations

  // Whether anything decides by this expectation: without bounds it is shown for its own sake.
  [[nodiscard]] bool decides(std::size_t expectation) const;
};

}  // namespace ssrkit
