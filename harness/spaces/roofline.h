// How much work the rooflines' passes do at each pixel (shaders/bench_*.frag): what divides their times.
#pragma once

namespace ssrkit {

inline constexpr int kRooflineFetchCount = 32;  // of bench_dependent_fetch and bench_fetch
inline constexpr int kRooflineAluCount = 64;    // of bench_alu: four multiply-adds each

}  // namespace ssrkit
