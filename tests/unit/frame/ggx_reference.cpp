#include "ggx_reference.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ssrkit {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr int kCellSide = 48;  // points of the quadrature along a cell's side

// D cosine dh = (1 - rise) 2 drise dturn by microfacetAt; what is left of the visible distribution is
// G1 (eye . h) / (eye.z h.z).
double visibleDensity(const GgxView& view, double rise, double turn) {
  const double alpha = view.roughness * view.roughness;
  const glm::dvec3 eye = toEye(view);
  const glm::dvec3 facet = microfacetAt(rise, turn, alpha);
  const double g1 = 1.0 / (1.0 + smithLambda(eye, alpha));
  return 2.0 * (1.0 - rise) * g1 * std::max(glm::dot(eye, facet), 0.0) / (eye.z * facet.z);
}

}  // namespace

glm::dvec3 toEye(const GgxView& view) {
  return {std::sqrt(1.0 - view.cosine * view.cosine), 0.0, view.cosine};
}

double smithLambda(const glm::dvec3& direction, double alpha) {
  const double cosine_2 = direction.z * direction.z;
  return 0.5 * (std::sqrt(1.0 + alpha * alpha * (1.0 - cosine_2) / cosine_2) - 1.0);
}

glm::dvec3 microfacetAt(double rise, double turn, double alpha) {
  const double left = (1.0 - rise) * (1.0 - rise);
  const double tangent = alpha * std::sqrt((1.0 - left) / left);
  const double cosine = 1.0 / std::sqrt(1.0 + tangent * tangent);
  return {tangent * cosine * std::cos(kTurn * turn), tangent * cosine * std::sin(kTurn * turn), cosine};
}

FacetPlace placeOf(const glm::dvec3& microfacet, double alpha) {
  const double tangent_2 =
      (microfacet.x * microfacet.x + microfacet.y * microfacet.y) / (microfacet.z * microfacet.z);
  const double left = 1.0 / (1.0 + tangent_2 / (alpha * alpha));
  const double turn = std::atan2(microfacet.y, microfacet.x) / kTurn;
  return {1.0 - std::sqrt(left), turn < 0.0 ? turn + 1.0 : turn};
}

std::vector<double> visibleCellProbabilities(const GgxView& view, int rise_count, int turn_count) {
  std::vector<double> probabilities;
  for (int cell = 0; cell < rise_count * turn_count; ++cell) {
    const int first_rise = cell / turn_count * kCellSide;
    const int first_turn = cell % turn_count * kCellSide;
    double sum = 0.0;
    for (int point = 0; point < kCellSide * kCellSide; ++point) {
      const int rise = first_rise + point / kCellSide;
      const int turn = first_turn + point % kCellSide;
      sum += visibleDensity(view, (rise + 0.5) / (kCellSide * rise_count),
                            (turn + 0.5) / (kCellSide * turn_count));
    }
    probabilities.push_back(sum / (kCellSide * kCellSide * rise_count * turn_count));
  }
  return probabilities;
}

VisibleFacet visibleFacet(const GgxView& view, double f0, double rise, double turn) {
  const double alpha = view.roughness * view.roughness;
  const glm::dvec3 eye = toEye(view);
  VisibleFacet facet{.direction = microfacetAt(rise, turn, alpha),
                     .density = visibleDensity(view, rise, turn),
                     .weight = 0.0};
  const double cosine = glm::dot(eye, facet.direction);
  const glm::dvec3 light = 2.0 * cosine * facet.direction - eye;
  if (cosine > 0.0 && light.z > 0.0) {
    const double visible = 1.0 + smithLambda(eye, alpha);
    const double fresnel = f0 + (1.0 - f0) * std::pow(1.0 - cosine, 5.0);
    facet.weight = fresnel * visible / (visible + smithLambda(light, alpha));
  }
  return facet;
}

double directionalAlbedo(const GgxView& view, double f0) {
  constexpr int kPoints = 192;
  double sum = 0.0;
  for (int point = 0; point < kPoints * kPoints; ++point) {
    const int rise = point / kPoints;
    const int turn = point % kPoints;
    const VisibleFacet facet = visibleFacet(view, f0, (rise + 0.5) / kPoints, (turn + 0.5) / kPoints);
    sum += facet.density * facet.weight;
  }
  return sum / (kPoints * kPoints);
}

}  // namespace ssrkit
