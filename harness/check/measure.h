// Every metric as a function of the expectation and the subject. None of them looks at the bounds, but for
// cpu ratios, whose noise decides whether the bounds can be judged at all.
#pragma once

#include "check/expectation.h"
#include "check/measurement.h"
#include "check/subject.h"

namespace ssrkit {

// By the expectation's metric. What cannot be measured has a `problem`.
[[nodiscard]] Measurement measure(const Expectation& expectation, const Subject& subject);

// measure_rays.cpp: held against the oracle or another record, ray by ray.
[[nodiscard]] Measurement measureDifferentRays(const Expectation& expectation, const Subject& subject);
[[nodiscard]] Measurement measureAmbiguousShare(const Subject& subject);
[[nodiscard]] Measurement measureVerdicts(const Expectation& expectation, const Subject& subject);
[[nodiscard]] Measurement measureVerdictGain(const Expectation& expectation, const Subject& subject);
[[nodiscard]] Measurement measureHitPosition(const Expectation& expectation, const Subject& subject);
[[nodiscard]] Measurement measureFoundShare(const Expectation& expectation, const Subject& subject);
[[nodiscard]] Measurement measureMaskFlips(const Expectation& expectation, const Subject& subject);

// measure_geometry.cpp: held against the true geometry.
[[nodiscard]] Measurement measureTrueClasses(const Expectation& expectation, const Subject& subject);
[[nodiscard]] Measurement measureGeometryVerdicts(const Expectation& expectation, const Subject& subject);
[[nodiscard]] Measurement measureTrueHitError(const Expectation& expectation, const Subject& subject);
// measure_banding.cpp: neighbour against neighbour.
[[nodiscard]] Measurement measureHitJump(const Expectation& expectation, const Subject& subject);

// measure_closed_form.cpp
[[nodiscard]] Measurement measureClosedForm(const Expectation& expectation, const Subject& subject);

// measure_identity.cpp: bit by bit.
[[nodiscard]] Measurement measureIdentical(const Expectation& expectation, const Subject& subject);

// measure_images.cpp: float images against another device's.
[[nodiscard]] Measurement measureCoverageFlips(const Expectation& expectation, const Subject& subject);
[[nodiscard]] Measurement measureImageError(const Expectation& expectation, const Subject& subject);

// measure_flip.cpp: pictures as somebody sees them.
[[nodiscard]] Measurement measureFlip(const Expectation& expectation, const Subject& subject);

// measure_lookups.cpp
[[nodiscard]] Measurement measureLookups(const Expectation& expectation, const Subject& subject);
[[nodiscard]] Measurement measureLookupRatio(const Expectation& expectation, const Subject& subject);
[[nodiscard]] Measurement measureP95LookupRatio(const Expectation& expectation, const Subject& subject);
[[nodiscard]] Measurement measureLookupsAdded(const Expectation& expectation, const Subject& subject);
[[nodiscard]] Measurement measureMissLookupRatio(const Subject& subject);

// measure_sampling.cpp: where the march looks.
[[nodiscard]] Measurement measureSampling(const Expectation& expectation, const Subject& subject);

// measure_steps.cpp: hits in the steps that found them.
[[nodiscard]] Measurement measureHitSteps(const Expectation& expectation, const Subject& subject);

// measure_time.cpp
[[nodiscard]] Measurement measureCpuRatio(const Expectation& expectation, const Subject& subject);
[[nodiscard]] Measurement measureRooflineMultiple(const Expectation& expectation, const Subject& subject);

// measure_cases.cpp: over several sets of parameters.
[[nodiscard]] Measurement measureConvergence(const Expectation& expectation, const Subject& subject);
[[nodiscard]] Measurement measureBudgetMonotone(const Expectation& expectation, const Subject& subject);

// measure_properties.cpp: judged by itself.
[[nodiscard]] Measurement measureProperty(const Expectation& expectation, const Subject& subject);

}  // namespace ssrkit
