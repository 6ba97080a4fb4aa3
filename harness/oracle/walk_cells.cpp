#include <algorithm>

#include "oracle/cell_walk.h"

namespace ssrkit {

std::vector<WalkCell> walkCells(const ColumnField& field, const ImageRay& ray, int own_x, int own_y) {
  std::vector<WalkCell> cells;
  double sigma_in = 0.0;
  for (CellStep cell(ray);; cell.step(ray)) {
    const double sigma_out = std::min(cell.sigmaOut(), ray.sigma_end);
    const bool is_own = cell.x == own_x && cell.y == own_y;
    if (!is_own) {
      if (cells.size() == field.lookup_budget) {
        return cells;
      }
      const double at_in = ray.invDistAt(sigma_in);
      const double at_out = ray.invDistAt(sigma_out);
      cells.push_back({.x = cell.x,
                       .y = cell.y,
                       .dist_in = 1.0 / at_in,
                       .dist_out = 1.0 / std::max(at_out, 0.0),
                       .t_in_m = ray.tMetresAt(sigma_in)});
      if (overlaps(field.column(cell.x, cell.y), at_in, at_out)) {
        return cells;
      }
    }
    if (!(sigma_out < ray.sigma_end)) {
      return cells;
    }
    sigma_in = sigma_out;
  }
}

}  // namespace ssrkit
