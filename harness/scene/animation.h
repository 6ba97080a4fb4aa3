// Values that change with time, as glTF's animation samplers define them (glTF 2.0, 3.11 and appendix C).
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <vector>

namespace ssrkit {

enum class Interpolation { kStep, kLinear, kCubicSpline };

// Keys of three or four numbers each; before the first key and after the last the curve stands still.
struct AnimationCurve {
  Interpolation interpolation = Interpolation::kLinear;
  std::vector<double> times_s;     // never empty, strictly increasing
  std::vector<glm::dvec4> values;  // one a key; kCubicSpline: in-tangent, value, out-tangent
};

[[nodiscard]] glm::dvec3 vectorAt(const AnimationCurve& curve, double time_s);

// Values are x, y, z, w, of unit length. kLinear turns evenly along the shorter way (slerp), kCubicSpline
// normalises the spline's value.
[[nodiscard]] glm::dquat rotationAt(const AnimationCurve& curve, double time_s);

}  // namespace ssrkit
