#include "march_reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ssrkit {

namespace {

constexpr double kTieShareOfDepth = 3e-5;
constexpr double kTieOfPositionPx = 2e-3;
constexpr double kMarginPx = 0.5;

struct Reference {
  RayClass ray_class = RayClass::kMasked;
  MarchSample hit;
  int samples = 0;
  int lookups = 0;
  bool is_tie = false;
};

// One ray's march over one depth image.
class March {
 public:
  March(const Job& job, const OracleInput& input, const MarchRules& rules, int x, int y)
      : dist_view_(job.gbuffer.at("dist_view")), input_(input), rules_(rules), x_(x), y_(y) {}

  Reference answer(const PixelRay& pixel) {
    ray_.line = pixel.ray;
    ray_.px_per_sigma = std::max(std::abs(pixel.ray.px_per_sigma.x), std::abs(pixel.ray.px_per_sigma.y));
    ray_.sigma_end = endOf(pixel.ray);
    Reference reference;
    reference.is_tie = pixel.is_start_tie || pixel.is_end_tie;
    MarchSample last{.sigma = 0.0, .dist_ray = 1.0 / pixel.ray.inv_dist_origin};
    while ((last.sigma < ray_.sigma_end && reference.samples < rules_.most_samples) ||
           reference.samples < rules_.least_samples) {
      const double dist_before = last.dist_ray;
      const double sigma_before = last.sigma;
      const double next = rules_.next(ray_, reference.samples + 1, last);
      if (rules_.looks_at_points && next >= ray_.sigma_end) {
        break;
      }
      ++reference.samples;
      // Just before the end or just beyond it: one sample more or less.
      is_tie_ =
          is_tie_ || (next != ray_.sigma_end && std::abs(next - ray_.sigma_end) <= 1e-5 * ray_.sigma_end);
      is_tie_ = is_tie_ || std::isnan(next);
      const double sigma = next < ray_.sigma_end ? next : ray_.sigma_end;
      last = sampleAt(sigma);
      reference.lookups += rules_.looks_at_points && isOwn(last) ? 0 : 1;
      if (hits(last, dist_before)) {
        reference.hit = refined(sigma_before, last);
        reference.ray_class = RayClass::kHit;
        reference.is_tie = reference.is_tie || is_tie_;
        return reference;
      }
    }
    reference.ray_class = pixel.ray.end_class;
    reference.is_tie = reference.is_tie || is_tie_;
    return reference;
  }

 private:
  [[nodiscard]] double endOf(const ImageRay& line) const {
    const double speed = std::max(std::abs(line.px_per_sigma.x), std::abs(line.px_per_sigma.y));
    const double margin = kMarginPx / std::max(speed, 1e-20);
    const double least_inv_dist = margin * std::abs(line.inv_dist_per_sigma);
    if (line.invDistAt(line.sigma_end) >= std::min(least_inv_dist, line.inv_dist_origin)) {
      return line.sigma_end;
    }
    return rules_.ends_by_metres
               ? ray_.sigmaAtMetres(line.sigma_end / std::min(least_inv_dist, line.inv_dist_origin))
               : std::max(line.sigma_end - margin, 0.0);
  }

  [[nodiscard]] MarchSample sampleAt(double sigma) {
    const glm::dvec2 px = ray_.line.pxAt(sigma);
    MarchSample sample{.sigma = sigma, .dist_ray = 1.0 / ray_.line.invDistAt(sigma)};
    sample.texel_x = std::clamp(static_cast<int>(std::floor(px.x)), 0, dist_view_.size.width - 1);
    sample.texel_y = std::clamp(static_cast<int>(std::floor(px.y)), 0, dist_view_.size.height - 1);
    sample.dist_surface = dist_view_.at(sample.texel_x, sample.texel_y);
    px_ = px;
    return sample;
  }

  [[nodiscard]] double columnFar(double dist) const {
    return dist + input_.parameters.thickness_m + input_.parameters.thickness_rel * dist;
  }

  [[nodiscard]] bool isOwn(const MarchSample& sample) const {
    return sample.texel_x == x_ && sample.texel_y == y_;
  }

  // Notes whether the next texel's depth, or a little more or less of the ray's, would have been decided
  // otherwise.
  bool decided(const MarchSample& sample, const std::function<bool(const MarchSample&)>& decide) {
    const bool decision = decide(sample);
    for (const double share : {-kTieShareOfDepth, kTieShareOfDepth}) {
      MarchSample moved = sample;
      moved.dist_ray *= 1.0 + share;
      is_tie_ = is_tie_ || decide(moved) != decision;
    }
    for (const glm::dvec2 shift : {glm::dvec2(-1, 0), {1, 0}, {0, -1}, {0, 1}}) {
      const glm::dvec2 at = px_ + kTieOfPositionPx * shift;
      MarchSample moved = sample;
      moved.texel_x = std::clamp(static_cast<int>(std::floor(at.x)), 0, dist_view_.size.width - 1);
      moved.texel_y = std::clamp(static_cast<int>(std::floor(at.y)), 0, dist_view_.size.height - 1);
      moved.dist_surface = dist_view_.at(moved.texel_x, moved.texel_y);
      is_tie_ =
          is_tie_ || decide(moved) != decision || (rules_.looks_at_points && isOwn(moved) != isOwn(sample));
      is_border_ = is_border_ || moved.texel_x != sample.texel_x || moved.texel_y != sample.texel_y;
    }
    return decision;
  }

  bool hits(const MarchSample& sample, double dist_before) {
    is_border_ = false;
    const bool hit = decided(sample, [&](const MarchSample& at) {
      const double nearest = rules_.looks_at_points ? at.dist_ray : std::min(at.dist_ray, dist_before);
      return at.dist_ray >= at.dist_surface && nearest < columnFar(at.dist_surface) && !isOwn(at);
    });
    is_tie_ = is_tie_ || (hit && is_border_);
    return hit;
  }

  MarchSample refined(double sigma_front, MarchSample behind) {
    for (int i = 0; i < rules_.bisections; ++i) {
      const double middle =
          rules_.bisects_metres
              ? ray_.sigmaAtMetres(0.5 * (ray_.metresAt(sigma_front) + ray_.metresAt(behind.sigma)))
              : 0.5 * (sigma_front + behind.sigma);
      const MarchSample sample = sampleAt(middle);
      is_border_ = false;
      const bool is_behind = decided(
          sample, [&](const MarchSample& at) { return at.dist_ray >= at.dist_surface && !isOwn(at); });
      is_tie_ = is_tie_ || (is_behind && is_border_);
      sigma_front = is_behind ? sigma_front : middle;
      behind = is_behind ? sample : behind;
    }
    return behind;
  }

  const Image& dist_view_;
  const OracleInput& input_;
  const MarchRules& rules_;
  int x_;
  int y_;
  MarchRay ray_;
  glm::dvec2 px_{0.0};
  bool is_tie_ = false;
  bool is_border_ = false;
};

std::string wordsOf(const RayHit& ray, const Reference& right, glm::dvec2 px) {
  return fmt::format("{} ({}, {}) at {}, {} after {} steps where {} ({}, {}) at {}, {} after {} is right",
                     name(ray.ray_class), ray.texel_x, ray.texel_y, ray.px_x, ray.px_y, ray.steps,
                     name(right.ray_class), right.hit.texel_x, right.hit.texel_y, px.x, px.y, right.samples);
}

}  // namespace

std::string differenceFromRules(const Job& job, const TraceParameters& parameters, const MarchRules& rules,
                                const RayRecord& record, double tie_share) {
  const OracleInput input{.camera = &*job.gbuffer_camera,
                          .dist_view = &job.gbuffer.at("dist_view"),
                          .normal_view = &job.gbuffer.at("normal_view"),
                          .parameters = parameters};
  const PixelProjection projection = pixelProjection(*job.gbuffer_camera);
  int rays = 0;
  int ties = 0;
  for (int y = 0; y < job.size.height; ++y) {
    for (int x = 0; x < job.size.width; ++x) {
      const PixelRay pixel = pixelRay(input, projection, x, y);
      if (!pixel.is_walked || job.gbuffer.at("material").at(x, y, 2) == 0.0F) {
        continue;
      }
      ++rays;
      const Reference right = March(job, input, rules, x, y).answer(pixel);
      if (right.is_tie) {
        ++ties;
        continue;
      }
      const RayHit& ray = record.at(x, y);
      const bool is_hit = right.ray_class == RayClass::kHit;
      const glm::dvec2 px = is_hit ? pixel.ray.pxAt(right.hit.sigma) : glm::dvec2(-1.0);
      const int bisections = is_hit ? rules.bisections : 0;
      const bool same = ray.ray_class == right.ray_class && ray.texel_x == right.hit.texel_x &&
                        ray.texel_y == right.hit.texel_y &&
                        ray.steps == static_cast<std::uint32_t>(right.samples + bisections) &&
                        ray.lookups == static_cast<std::uint32_t>(right.lookups + bisections) &&
                        glm::length(glm::dvec2(ray.px_x, ray.px_y) - px) <= kTieOfPositionPx;
      if (!same) {
        return fmt::format("pixel {}, {}: {}", x, y, wordsOf(ray, right, px));
      }
    }
  }
  if (rays == 0 || ties > tie_share * rays) {
    return fmt::format("{} of {} rays are ties", ties, rays);
  }
  return "";
}

}  // namespace ssrkit
