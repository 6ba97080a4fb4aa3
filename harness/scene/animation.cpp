#include "scene/animation.h"

#include <algorithm>

namespace ssrkit {

namespace {

// The keys around a time, and how far it is between them.
struct Between {
  std::size_t from = 0;
  std::size_t to = 0;
  double share = 0.0;
  double span_s = 0.0;
};

Between locate(const AnimationCurve& curve, double time_s) {
  const auto next = std::upper_bound(curve.times_s.begin(), curve.times_s.end(), time_s);
  const auto index = static_cast<std::size_t>(next - curve.times_s.begin());
  if (index == 0 || next == curve.times_s.end()) {
    const std::size_t end = index == 0 ? 0 : index - 1;
    return {end, end, 0.0, 0.0};
  }
  const double span_s = curve.times_s[index] - curve.times_s[index - 1];
  return {index - 1, index, (time_s - curve.times_s[index - 1]) / span_s, span_s};
}

// glTF 2.0, appendix C.5: tangents are per second, so they are scaled by the time between the keys.
glm::dvec4 splineAt(const AnimationCurve& curve, const Between& at) {
  const double s = at.share;
  const double s2 = s * s;
  const double s3 = s2 * s;
  const glm::dvec4& value_from = curve.values[3 * at.from + 1];
  const glm::dvec4& tangent_out = curve.values[3 * at.from + 2];
  const glm::dvec4& tangent_in = curve.values[3 * at.to];
  const glm::dvec4& value_to = curve.values[3 * at.to + 1];
  return (2.0 * s3 - 3.0 * s2 + 1.0) * value_from + at.span_s * (s3 - 2.0 * s2 + s) * tangent_out +
         (-2.0 * s3 + 3.0 * s2) * value_to + at.span_s * (s3 - s2) * tangent_in;
}

glm::dquat quaternion(const glm::dvec4& xyzw) {
  return {xyzw.w, xyzw.x, xyzw.y, xyzw.z};
}

}  // namespace

glm::dvec3 vectorAt(const AnimationCurve& curve, double time_s) {
  const Between at = locate(curve, time_s);
  switch (curve.interpolation) {
    case Interpolation::kCubicSpline:
      return glm::dvec3(splineAt(curve, at));
    case Interpolation::kLinear:
      return glm::dvec3(glm::mix(curve.values[at.from], curve.values[at.to], at.share));
    case Interpolation::kStep:
      break;
  }
  return glm::dvec3(curve.values[at.from]);
}

glm::dquat rotationAt(const AnimationCurve& curve, double time_s) {
  const Between at = locate(curve, time_s);
  switch (curve.interpolation) {
    case Interpolation::kCubicSpline: {
      const glm::dvec4 value = splineAt(curve, at);
      const double length = glm::length(value);
      // Opposite keys can make a spline pass through zero, where it says no direction.
      return quaternion(length > 1e-12 ? value / length : curve.values[3 * at.from + 1]);
    }
    case Interpolation::kLinear:
      return glm::normalize(
          glm::slerp(quaternion(curve.values[at.from]), quaternion(curve.values[at.to]), at.share));
    case Interpolation::kStep:
      break;
  }
  return quaternion(curve.values[at.from]);
}

}  // namespace ssrkit
