// GGX in double precision, by quadrature over the microfacets: nothing here samples, so nothing is shared
// with the shaders that do.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace ssrkit {

// Directions are unit vectors in the frame of the normal, z; the eye lies over the x axis.
struct GgxView {
  double cosine = 1.0;     // between normal and eye
  double roughness = 0.5;  // alpha is its square
};

[[nodiscard]] glm::dvec3 toEye(const GgxView& view);
[[nodiscard]] double smithLambda(const glm::dvec3& direction, double alpha);

// Microfacets are numbered by `rise` 0..1 from the normal outwards and `turn` 0..1 about it. 1 - (1 - rise)^2
// is the cumulative distribution of D cosine, so that every alpha spreads evenly, and no density grows beyond
// bounds.
[[nodiscard]] glm::dvec3 microfacetAt(double rise, double turn, double alpha);
struct FacetPlace {
  double rise;
  double turn;
};
[[nodiscard]] FacetPlace placeOf(const glm::dvec3& microfacet, double alpha);

// Probability that a visible microfacet lies in each of rise_count x turn_count equal cells, turn running
// fastest.
[[nodiscard]] std::vector<double> visibleCellProbabilities(const GgxView& view, int rise_count,
                                                           int turn_count);

// One microfacet of a quadrature: how dense visible ones lie there over (rise, turn), and what the ray
// reflected at it weighs, Schlick's Fresnel of `f0` times G2 / G1; 0 for rays below the surface.
struct VisibleFacet {
  glm::dvec3 direction;
  double density;
  double weight;
};
[[nodiscard]] VisibleFacet visibleFacet(const GgxView& view, double f0, double rise, double turn);

// The integral over the hemisphere of brdf * cosine, what a white environment is reflected as.
[[nodiscard]] double directionalAlbedo(const GgxView& view, double f0);

}  // namespace ssrkit
