#include "environment/split_sum.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/share_out.h"

namespace ssrkit {

namespace {

constexpr int kRadialCount = 16;
constexpr int kAzimuthCount = 16;

struct Node {
  double position;  // in (0, 1)
  double weight;
};

// Gauss and Legendre's nodes on (0, 1): the roots of the Legendre polynomial by Newton's method (Abramowitz
// and Stegun, "Handbook of Mathematical Functions", 25.4.29). They crowd at both ends, where the integrand
// bends most.
std::array<Node, kRadialCount> gaussNodes() {
  std::array<Node, kRadialCount> nodes{};
  constexpr double kCount = kRadialCount;
  for (int i = 0; i < kRadialCount; ++i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (kCount + 0.5));
    double slope = 1.0;
    constexpr int kIterations = 8;
    for (int iteration = 0; iteration < kIterations; ++iteration) {
      double before = 1.0;
      double value = x;
      for (int k = 2; k <= kRadialCount; ++k) {
        before = std::exchange(value, ((2 * k - 1) * x * value - (k - 1) * before) / k);
      }
      slope = kCount * (x * value - before) / (x * x - 1.0);
      x -= value / slope;
    }
    nodes[static_cast<std::size_t>(i)] = {0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope)};
  }
  return nodes;
}

// Smith's Lambda for a direction at this cosine (Heitz, "Understanding the Masking-Shadowing Function", JCGT
// 3(2) 2014, eq. 72).
double lambda(double cosine, double alpha2) {
  const double cos2 = cosine * cosine;
  return 0.5 * (std::sqrt(1.0 + alpha2 * (1.0 - cos2) / cos2) - 1.0);
}

}  // namespace

// Over half vectors: their azimuth from the viewer's plane, at the middle of equal steps, and the tangent of
// their angle to the normal, from 0 to where the reflected direction meets the horizon. There the integrand
// ends for good, so the rule never straddles its edge. tangent = alpha t / (1 - t) spreads the lobe evenly
// over t.
glm::vec2 splitSum(float cos_view, float roughness) {
  static const std::array<Node, kRadialCount> kNodes = gaussNodes();
  const double view_z = cos_view;
  const double view_x = std::sqrt(1.0 - view_z * view_z);
  const double alpha = static_cast<double>(roughness) * roughness;
  const double alpha2 = alpha * alpha;
  const double lambda_view = lambda(view_z, alpha2);
  glm::dvec2 sum(0.0);
  for (int step = 0; step < kAzimuthCount; ++step) {
    const double across = view_x * std::cos(std::numbers::pi * (step + 0.5) / kAzimuthCount);
    const double horizon = (across + std::sqrt(across * across + view_z * view_z)) / view_z;
    const double last_t = horizon / (alpha + horizon);
    for (const Node& node : kNodes) {
      const double t = last_t * node.position;
      const double tangent = alpha * t / (1.0 - t);
      const double cos2 = 1.0 / (1.0 + tangent * tangent);
      const double cos_normal = std::sqrt(cos2);
      const double sine = tangent * cos_normal;
      const double shape = cos2 * (alpha2 - 1.0) + 1.0;
      const double density = alpha2 / (std::numbers::pi * shape * shape);
      const double cos_half = across * sine + view_z * cos_normal;
      const double cos_light = 2.0 * cos_half * cos_normal - view_z;
      const double masking = 1.0 / (1.0 + lambda_view + lambda(cos_light, alpha2));
      const double angle_per_t = cos2 * alpha / ((1.0 - t) * (1.0 - t));
      const double weight = density * masking * cos_half / view_z * sine * angle_per_t * last_t * node.weight;
      const double grazing = 1.0 - cos_half;
      const double fresnel = grazing * grazing * grazing * grazing * grazing;
      sum += weight * glm::dvec2(1.0 - fresnel, fresnel);
    }
  }
  return glm::vec2(sum * (2.0 * std::numbers::pi / kAzimuthCount));
}

std::vector<glm::vec2> splitSumTable() {
  // At 0 itself the surface is seen from the edge, or is a mirror whose lobe has no width: both are limits.
  constexpr float kLeastRoot = 0.02F;
  constexpr float kLeastRoughness = 0.01F;
  std::vector<glm::vec2> table(static_cast<std::size_t>(kSplitSumSide) * kSplitSumSide);
  const auto at = [](int i) { return static_cast<float>(i) / static_cast<float>(kSplitSumSide - 1); };
  forEachInParallel(kSplitSumSide, 0, [&](int row) {
    for (int column = 0; column < kSplitSumSide; ++column) {
      const float root = std::max(at(column), kLeastRoot);
      table[static_cast<std::size_t>(row) * kSplitSumSide + static_cast<std::size_t>(column)] =
          splitSum(root * root, std::max(at(row), kLeastRoughness));
    }
  });
  return table;
}

}  // namespace ssrkit
