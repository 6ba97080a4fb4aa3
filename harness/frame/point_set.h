// The kinds of points that techniques sample with: point_set of shaders/include/random.glsl.
#pragma once

namespace ssrkit {

inline constexpr int kWhitePoints = 0;
inline constexpr int kBlueHammersley = 2;

}  // namespace ssrkit
