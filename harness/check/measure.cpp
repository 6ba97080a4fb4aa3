#include "check/measure.h"

namespace ssrkit {

Measurement measure(const Expectation& expectation, const Subject& subject) {
  switch (expectation.metric) {
    case Metric::kDifferentRays:
      return measureDifferentRays(expectation, subject);
    case Metric::kAmbiguousShare:
      return measureAmbiguousShare(subject);
    case Metric::kVerdicts:
    case Metric::kVerdictShare:
      return measureVerdicts(expectation, subject);
    case Metric::kVerdictGain:
      return measureVerdictGain(expectation, subject);
    case Metric::kHitPositionPx:
      return expectation.truth.kind == TruthKind::kGeometry ? measureTrueHitError(expectation, subject)
                                                            : measureHitPosition(expectation, subject);
    case Metric::kTrueClassShare:
      return measureTrueClasses(expectation, subject);
    case Metric::kTrueVerdictShare:
      return measureGeometryVerdicts(expectation, subject);
    case Metric::kHitDistanceError:
      return measureTrueHitError(expectation, subject);
    case Metric::kHitJumpPx:
      return measureHitJump(expectation, subject);
    case Metric::kFoundShare:
      return measureFoundShare(expectation, subject);
    case Metric::kClosedForm:
    case Metric::kClosedFormLookups:
      return measureClosedForm(expectation, subject);
    case Metric::kIdentical:
      return measureIdentical(expectation, subject);
    case Metric::kCoverageFlips:
      return measureCoverageFlips(expectation, subject);
    case Metric::kRelativeError:
    case Metric::kAbsoluteError:
      return measureImageError(expectation, subject);
    case Metric::kFlip:
      return measureFlip(expectation, subject);
    case Metric::kMaskFlipsPerMillion:
      return measureMaskFlips(expectation, subject);
    case Metric::kMeanLookups:
    case Metric::kP95Lookups:
    case Metric::kMaxLookups:
      return measureLookups(expectation, subject);
    case Metric::kLookupRatio:
      return measureLookupRatio(expectation, subject);
    case Metric::kP95LookupRatio:
      return measureP95LookupRatio(expectation, subject);
    case Metric::kLookupsAdded:
      return measureLookupsAdded(expectation, subject);
    case Metric::kMissLookupRatio:
      return measureMissLookupRatio(subject);
    case Metric::kResampledShare:
    case Metric::kSkippedShare:
      return measureSampling(expectation, subject);
    case Metric::kCpuRatio:
    case Metric::kPixelCpuRatio:
    case Metric::kWallRatio:
    case Metric::kPassCpuShare:
    case Metric::kPassCpuLead:
      return measureCpuRatio(expectation, subject);
    case Metric::kRooflineMultiple:
      return measureRooflineMultiple(expectation, subject);
    case Metric::kConvergence:
      return measureConvergence(expectation, subject);
    case Metric::kBudgetMonotone:
      return measureBudgetMonotone(expectation, subject);
    case Metric::kFinite:
    case Metric::kNoSelfHit:
    case Metric::kHitPointInTexel:
    case Metric::kInsideImage:
    case Metric::kLookupsWithinBudget:
    case Metric::kClassConsistent:
      return measureProperty(expectation, subject);
  }
  return cannotMeasure("the metric is not known");
}

}  // namespace ssrkit
