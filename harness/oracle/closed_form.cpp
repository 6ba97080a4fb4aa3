#include "oracle/closed_form.h"

#include <array>
#include <cmath>

#include "oracle/formula.h"

namespace ssrkit {

namespace {

const std::array<ClosedForm, 4>& closedForms() {
  static const std::array<ClosedForm, 4> forms = {
      ClosedForm{"m1", "row' = 1.25 H - row - 1, same column; 2 row - 1.25 H + 1 cells", &expectedM1},
      ClosedForm{"m2", "dist = 2D - hf/|Y|, seen at (X, -|Y|) (2D - dist) / dist", &expectedM2},
      ClosedForm{"m3", "m1 and the quad: false hits where Y_low + 2hf/(D_q + T) <= |Y| < Y_low + 2hf/D_q",
                 &expectedM3},
      ClosedForm{"m4", "the side wall where 1/dist of the lateral ray falls to X' a / (f x_w)", &expectedM4}};
  return forms;
}

}  // namespace

const ClosedForm* findClosedForm(std::string_view scene) {
  for (const ClosedForm& form : closedForms()) {
    if (form.scene == scene) {
      return &form;
    }
  }
  return nullptr;
}

ExpectedRay expectedAt(std::string_view scene, Size size, const TraceParameters& parameters, int x, int y) {
  const ClosedForm* form = findClosedForm(scene);
  if (form == nullptr) {
    return undecided("the scene has no closed form");
  }
  if (!std::isinf(parameters.max_distance_m) || parameters.origin_bias != 0.0) {
    return undecided("the formulas hold for an unbiased ray of unlimited length");
  }
  ExpectedRay ray = form->expected(size, parameters, x, y);
  if (ray.lookups > parameters.lookup_budget) {
    ExpectedRay spent = decided(RayClass::kBudget);
    spent.lookups = parameters.lookup_budget;
    return spent;
  }
  const bool is_walked_miss = ray.ray_class == RayClass::kRange || ray.ray_class == RayClass::kOffscreen;
  if (is_walked_miss && parameters.lookup_budget < size.width + size.height) {
    return undecided("the formulas do not count the cells of a ray that hits nothing");
  }
  return ray;
}

}  // namespace ssrkit
