// Vectors of one float or int a ray.
#pragma once

#include <cstddef>
#include <experimental/simd>

#include "native/hiz_kernel.h"

namespace ssrkit {
namespace {

namespace stdx = std::experimental;

using Floats = stdx::native_simd<float>;
using Ints = stdx::rebind_simd_t<int, Floats>;
using Mask = Floats::mask_type;

constexpr int kLaneCount = static_cast<int>(Floats::size());

struct Pair {
  Floats x;
  Floats y;
};

inline Pair operator+(const Pair& a, const Pair& b) {
  return {a.x + b.x, a.y + b.y};
}
inline Pair operator+(const Pair& a, Floats b) {
  return {a.x + b, a.y + b};
}
inline Pair operator*(const Pair& a, Floats b) {
  return {a.x * b, a.y * b};
}

struct Triple {
  Floats x;
  Floats y;
  Floats z;
};

inline Floats chosen(Mask mask, Floats yes, Floats no) {
  stdx::where(mask, no) = yes;
  return no;
}

// The sums of ssr_ordered.glsl.
inline Floats orderedDot(const Triple& a, const Triple& b) {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

inline Triple orderedNormalize(const Triple& v) {
  const Floats length = stdx::sqrt(orderedDot(v, v));
  return {v.x / length, v.y / length, v.z / length};
}

// Lanes that are not active may stand anywhere, so they read the pyramid's first cell.
inline Pair loadPyramid(const HizScene& scene, const Pair& cell, Floats cell_size_px, Mask active) {
  const Floats first_row = scene.pyramid_rows - scene.pyramid_rows / cell_size_px;
  const auto row = stdx::static_simd_cast<Ints>(chosen(active, first_row + cell.y, 0.0F));
  const auto column = stdx::static_simd_cast<Ints>(chosen(active, cell.x, 0.0F));
  const Ints index = 2 * (row * scene.pyramid_width + column);
  const auto entry = [&](int offset) {
    return Floats(
        [&](auto lane) { return scene.pyramid[static_cast<std::ptrdiff_t>(index[lane]) + offset]; });
  };
  return {entry(0), entry(1)};
}

}  // namespace
}  // namespace ssrkit
