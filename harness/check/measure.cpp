#include "check/measure.h"

namespace ssrkit {

Measurement measure(const Expectation& expectation, const Subject& subject) {
  return row(expectation.metric).measure(expectation, subject);
}

}  // namespace ssrkit
