// The same buffer from two answers.
#pragma once

#include <functional>
#include <string>

#include "check/expectation.h"
#include "check/measurement.h"
#include "check/subject.h"

namespace ssrkit {

struct ImagePair {
  const Image* yours = nullptr;
  const Image* expected = nullptr;
  std::string problem;  // absent, or of different sizes or channels
};

[[nodiscard]] ImagePair pairImages(const Expectation& expectation, const Subject& subject);

// A finding for each pixel whose largest `error(yours, expected)` over its channels is above 0; that error is
// the severity.
[[nodiscard]] Measurement measureImagePair(const ImagePair& images,
                                           const std::function<double(float yours, float expected)>& error);

}  // namespace ssrkit
