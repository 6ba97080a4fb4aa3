// The marches in double precision, along the straight line that a ray is on the image (oracle/image_ray.h):
// what sampled tracers must answer, sample by sample.
#pragma once

#include <functional>
#include <string>

#include "frame/job.h"
#include "oracle/image_ray.h"

namespace ssrkit {

// A sample of a ray: where it is, and what the depth image has there.
struct MarchSample {
  double sigma = 0.0;
  double dist_ray = 0.0;
  double dist_surface = 0.0;
  int texel_x = -1;
  int texel_y = -1;
};

// Whole rays as the marches cut them off: half a pixel before a vanishing point.
struct MarchRay {
  ImageRay line;
  double px_per_sigma = 0.0;  // along the longer axis
  double sigma_end = 0.0;

  [[nodiscard]] double metresAt(double sigma) const { return sigma / line.invDistAt(sigma); }
  [[nodiscard]] double sigmaAtMetres(double t_m) const {
    return t_m * line.inv_dist_origin / (1.0 - t_m * line.inv_dist_per_sigma);
  }
};

// Where sample number `count`, from 1, is looked at, the one before given; beyond the ray's end for the end.
// No number where rounding decides.
using NextSigma = std::function<double(const MarchRay& ray, int count, const MarchSample& last)>;

struct MarchRules {
  NextSigma next;
  int bisections = 0;
  bool bisects_metres = false;  // else pixels
  bool ends_by_metres = true;   // the margin at the vanishing point in metres, else in pixels
  // A sample hits the column that it lies in, not the one that the step before it met; the ray's end is not
  // looked at, and the ray's own texel costs no lookup.
  bool looks_at_points = false;
  int least_samples = 0;
  int most_samples = 60000;
};

// "" when the record is what the rules give for every reflective pixel of the job's G-buffer, else the first
// difference with its pixel. Rays that rounding may decide either way are left out; more than `tie_share` of
// them is a difference.
[[nodiscard]] std::string differenceFromRules(const Job& job, const TraceParameters& parameters,
                                              const MarchRules& rules, const RayRecord& record,
                                              double tie_share);

}  // namespace ssrkit
