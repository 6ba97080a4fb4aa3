#include "check/signatures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>

#include "oracle/cell_walk.h"
#include "oracle/image_ray.h"

namespace ssrkit {

namespace {

constexpr std::size_t kFewestWrongRays = 4;
constexpr double kMostOf = 0.9;

template <class Predicate>
std::size_t countIf(std::span<const RayPair> rays, Predicate predicate) {
  return static_cast<std::size_t>(std::ranges::count_if(rays, predicate));
}

template <class Predicate>
bool mostOf(std::span<const RayPair> rays, Predicate predicate) {
  return rays.size() >= kFewestWrongRays &&
         static_cast<double>(countIf(rays, predicate)) >= kMostOf * static_cast<double>(rays.size());
}

bool youHit(const RayPair& pair) {
  return pair.yours->ray_class == RayClass::kHit;
}
bool truthHits(const RayPair& pair) {
  return pair.expected->ray_class == RayClass::kHit;
}
bool isMissedHit(const RayPair& pair) {
  return truthHits(pair) && !youHit(pair);
}
bool isFalseHit(const RayPair& pair) {
  return youHit(pair) && !truthHits(pair);
}

bool hitsOwnTexel(const SignatureInput& input) {
  return mostOf(input.wrong, [](const RayPair& pair) {
    return youHit(pair) && pair.yours->texel_x == pair.x && pair.yours->texel_y == pair.y;
  });
}

bool hitsBackground(const SignatureInput& input) {
  const OracleInput* world = input.self.oracle_input;
  return world != nullptr && mostOf(input.wrong, [&](const RayPair& pair) {
           const RayHit& hit = *pair.yours;
           const Size size = world->dist_view->size;
           const bool inside =
               hit.texel_x >= 0 && hit.texel_y >= 0 && hit.texel_x < size.width && hit.texel_y < size.height;
           return youHit(pair) && inside && !std::isfinite(world->dist_view->at(hit.texel_x, hit.texel_y));
         });
}

bool reportsBudgetAsHit(const SignatureInput& input) {
  const auto budget = static_cast<std::uint32_t>(input.self.parameters.lookup_budget);
  return mostOf(input.wrong,
                [&](const RayPair& pair) { return youHit(pair) && pair.yours->lookups >= budget; });
}

bool spendsBudget(const SignatureInput& input) {
  return mostOf(input.wrong, [](const RayPair& pair) {
    return pair.yours->ray_class == RayClass::kBudget && pair.expected->ray_class != RayClass::kBudget;
  });
}

bool mirrorsRows(const SignatureInput& input) {
  const int height = input.self.size.height;
  return mostOf(input.wrong, [height](const RayPair& pair) {
    return bothHit(pair) && pair.yours->texel_y == height - 1 - pair.expected->texel_y;
  });
}

bool mirrorsColumns(const SignatureInput& input) {
  const int width = input.self.size.width;
  return mostOf(input.wrong, [width](const RayPair& pair) {
    return bothHit(pair) && pair.yours->texel_x == width - 1 - pair.expected->texel_x;
  });
}

// The same offset of at most one texel everywhere, whatever the ray's heading.
bool isOffByOneTexel(const SignatureInput& input) {
  std::map<std::pair<int, int>, std::size_t> offsets;
  for (const RayPair& pair : input.wrong) {
    if (bothHit(pair)) {
      ++offsets[{pair.yours->texel_x - pair.expected->texel_x, pair.yours->texel_y - pair.expected->texel_y}];
    }
  }
  return input.wrong.size() >= kFewestWrongRays && std::ranges::any_of(offsets, [&](const auto& entry) {
           const auto& [offset, count] = entry;
           return offset != std::pair(0, 0) && std::abs(offset.first) <= 1 && std::abs(offset.second) <= 1 &&
                  static_cast<double>(count) >= kMostOf * static_cast<double>(input.wrong.size());
         });
}

// How far, in texels along the longer axis of its way, the answer lies past the true hit.
std::optional<int> texelsPast(const RayPair& pair) {
  const int way_x = pair.expected->texel_x - pair.x;
  const int way_y = pair.expected->texel_y - pair.y;
  const int past_x = pair.yours->texel_x - pair.expected->texel_x;
  const int past_y = pair.yours->texel_y - pair.expected->texel_y;
  if (!bothHit(pair) || (way_x == 0 && way_y == 0)) {
    return std::nullopt;
  }
  if (std::abs(way_x) >= std::abs(way_y)) {
    return way_x > 0 ? past_x : -past_x;
  }
  return way_y > 0 ? past_y : -past_y;
}

// One stride past the hit along the way of each ray. Tried after the constant offset, which explains as much
// where all rays run the same way.
bool overshootsOneStride(const SignatureInput& input) {
  const int stride_px = std::max(1, input.self.parameters.stride_px);
  return mostOf(input.wrong, [stride_px](const RayPair& pair) { return texelsPast(pair) == stride_px; });
}

// Every hit falls short, on the ray's own line.
bool fallsShort(const SignatureInput& input) {
  return mostOf(input.wrong, [](const RayPair& pair) {
    const std::optional<int> past = texelsPast(pair);
    const int way =
        std::max(std::abs(pair.expected->texel_x - pair.x), std::abs(pair.expected->texel_y - pair.y));
    return past && *past < -1 && -*past < way;
  });
}

bool isTowardCamera(const SignatureInput& input, const PixelProjection& projection, const RayPair& pair) {
  const PixelRay pixel = pixelRay(*input.self.oracle_input, projection, pair.x, pair.y);
  return pixel.is_walked && pixel.ray.inv_dist_per_sigma > 0.0;
}

// Rays that come back toward the camera are lost, the others are right.
bool losesRaysTowardCamera(const SignatureInput& input) {
  if (input.self.oracle_input == nullptr || !mostOf(input.wrong, isMissedHit)) {
    return false;
  }
  const PixelProjection projection = pixelProjection(*input.self.oracle_input->camera);
  const auto toward = [&](const RayPair& pair) { return isTowardCamera(input, projection, pair); };
  const std::size_t toward_hits =
      countIf(input.all, [&](const RayPair& pair) { return truthHits(pair) && toward(pair); });
  const bool most_lost =
      static_cast<double>(input.wrong.size()) >= kMostOf * static_cast<double>(toward_hits);
  return most_lost && mostOf(input.wrong, toward);
}

bool losesLastRowOrColumn(const SignatureInput& input) {
  const Size size = input.self.size;
  const bool odd = size.width % 2 == 1 || size.height % 2 == 1;
  return odd && mostOf(input.wrong, [size](const RayPair& pair) {
           return truthHits(pair) &&
                  (pair.expected->texel_x == size.width - 1 || pair.expected->texel_y == size.height - 1);
         });
}

// Hits where the oracle's ray passes behind the texel's column.
bool ignoresThickness(const SignatureInput& input) {
  const OracleInput* world = input.self.oracle_input;
  const TraceParameters& parameters = input.self.parameters;
  if (world == nullptr || !std::isfinite(parameters.thickness_m)) {
    return false;
  }
  const PixelProjection projection = pixelProjection(*world->camera);
  const ColumnField field = columnField(*world);
  return mostOf(input.wrong, [&](const RayPair& pair) {
    const PixelRay pixel = pixelRay(*world, projection, pair.x, pair.y);
    const std::vector<WalkCell> cells = youHit(pair) && pixel.is_walked
                                            ? walkCells(field, pixel.ray, pair.x, pair.y)
                                            : std::vector<WalkCell>{};
    return std::ranges::any_of(cells, [&](const WalkCell& cell) {
      return cell.x == pair.yours->texel_x && cell.y == pair.yours->texel_y &&
             std::min(cell.dist_in, cell.dist_out) >= field.column(cell.x, cell.y).far_dist;
    });
  });
}

bool neverHits(const SignatureInput& input) {
  return mostOf(input.wrong, isMissedHit) && countIf(input.all, youHit) == 0;
}

bool alwaysHits(const SignatureInput& input) {
  return mostOf(input.wrong, isFalseHit) && countIf(input.all, youHit) == input.all.size();
}

}  // namespace

std::span<const Signature> signatures() {
  static const std::vector<Signature> rows = {
      {"self-hit", hitsOwnTexel,
       "the rays hit the texel that they start from: leave out the ray's own texel, by its identity"},
      {"background-hit", hitsBackground,
       "the hits lie on background: its dist_view is +inf and is never hit; look for 1/dist_view past the "
       "ray's end, "
       "where it turns negative"},
      {"budget-as-hit", reportsBudgetAsHit,
       "rays that spent their lookup budget are reported as hits: leave the loop with class BUDGET instead"},
      {"budget", spendsBudget,
       "the rays spend their whole lookup budget: the march is stuck in a cell, or steps too finely"},
      {"y-flip", mirrorsRows,
       "the rows are mirrored: p_px has its origin in the upper left and +y runs down, on every API"},
      {"x-flip", mirrorsColumns, "the columns are mirrored: view space has +x to the right, as p_px has"},
      {"toward-camera", losesRaysTowardCamera,
       "rays that come back toward the camera are lost: along them dist_view falls, so the interval's ends "
       "must "
       "change places before they are compared"},
      {"never-hits", neverHits,
       "no ray hits anything: look at the sign of the depth test, or at rays that end where they begin"},
      {"always-hits", alwaysHits, "every ray hits: the depth test is always true, or its sign is wrong"},
      {"texel-centre", isOffByOneTexel,
       "all hits are off by the same texel: a texel's centre is at .5, and texel = floor(p_px), not a "
       "rounding"},
      {"overshoot", overshootsOneStride,
       "the hits lie one stride past the true ones: the march steps once more after it has found its hit"},
      {"last-row-or-column", losesLastRowOrColumn,
       "only hits in the last row or column are lost: at odd sizes a coarser level must cover the odd row "
       "and column "
       "too"},
      {"thickness", ignoresThickness,
       "the rays pass behind what they are said to hit: the far side, Z + thickness, is not tested or has "
       "the wrong "
       "sign"},
      {"linear-depth", fallsShort,
       "the hits fall short along the ray: 1/dist_view, not dist_view, is linear along the projected ray"},
  };
  return rows;
}

const Signature* matchSignature(const SignatureInput& input) {
  const auto found = std::ranges::find_if(
      signatures(), [&](const Signature& signature) { return signature.matches(input); });
  return found == signatures().end() ? nullptr : &*found;
}

std::optional<std::string> likelyCause(const SignatureInput& input) {
  const Signature* signature = matchSignature(input);
  if (signature == nullptr) {
    return std::nullopt;
  }
  return fmt::format("{} [{}]", signature->cause, signature->id);
}

}  // namespace ssrkit
