// Well-known mistakes by the mark they leave: "every hit is one row too low" names its cause where "57600
// rays differ" does not. Each signature is a row of data: what must be seen, and what it says.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "check/ray_pairs.h"
#include "check/subject.h"

namespace ssrkit {

struct SignatureInput {
  std::span<const RayPair> all;    // every ray compared
  std::span<const RayPair> wrong;  // those that disagree
  const Answer& self;
};

struct Signature {
  std::string id;  // "texel-centre"
  bool (*matches)(const SignatureInput& input);
  std::string cause;  // one sentence, for the person who wrote the shader
};

// In the order in which they are tried: the most specific first.
[[nodiscard]] std::span<const Signature> signatures();

// The first signature that nine in ten of the wrong rays bear; null when none does or fewer than 4 rays are
// wrong, too few to tell a mark from chance.
[[nodiscard]] const Signature* matchSignature(const SignatureInput& input);

// Its sentence, with its id.
[[nodiscard]] std::optional<std::string> likelyCause(const SignatureInput& input);

}  // namespace ssrkit
