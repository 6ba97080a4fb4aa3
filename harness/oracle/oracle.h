// Oracle A: the exact cell-by-cell walk of the tracing contract (docs/spaces.md, "The tracing contract"), in
// double precision on the CPU, over the very depth image that a shader read. Written from the contract, not
// from the shaders, and checked by the closed forms.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/error.h"
#include "image/image.h"
#include "image/ray_record.h"
#include "spaces/camera.h"
#include "spaces/trace_parameters.h"

namespace ssrkit {

// What the oracle reads. All images have the camera's size.
struct OracleInput {
  const Camera* camera = nullptr;
  const Image* dist_view = nullptr;    // 1 channel, metres, +inf for background
  const Image* normal_view = nullptr;  // 4 channels: unit normal; the 4th is the cosine between the reflected
                                       // direction and the geometric normal, negative: INTO_SURFACE. 3
                                       // channels: only the shading normal decides
  const Image* mask = nullptr;         // 1 channel, 0: MASKED; absent: every pixel reflects
  TraceParameters parameters;
};

// Fails on images whose size or channels do not fit the camera, and on parameters outside the contract.
[[nodiscard]] Expected<void> checkInput(const OracleInput& input);

// Why a ray's answer is a tie in single precision. Such rays are listed (oracle/hit.exr, `tie`) and capped,
// never dropped silently. The numbers are part of the file format (docs/formats.md).
enum class Ambiguity : std::uint8_t {
  kNone = 0,
  kDepth,     // a column's near or far depth is met within 5e-6 relative
  kPosition,  // a cell that would decide is entered or missed by less than 5e-4 px
  kEnd,       // the ray's end (image edge, near plane, range, into the surface) is a tie
};

struct OracleResult {
  RayRecord record;                  // lookups = cells visited, the ray's own not counted; steps = the same
  std::vector<Ambiguity> ambiguity;  // one a pixel
  // Cells crossed by the ray up to its hit in order are not stored; see `cellsOf`.
};

// The record's channels, and `tie`: the ray's Ambiguity.
[[nodiscard]] Image toImage(const OracleResult& result);

// The whole image, on `thread_count` threads (0: one for each core). Fails where checkInput does.
[[nodiscard]] Expected<OracleResult> traceOracle(const OracleInput& input, int thread_count = 0);

// One cell of one ray's walk, for LEAK classification and the ray microscope.
struct WalkCell {
  int x = 0;
  int y = 0;
  double dist_in = 0.0;  // the ray's dist_view where it enters and leaves the cell
  double dist_out = 0.0;
  double t_in_m = 0.0;
};

// The cells that the ray of pixel (x, y) visits, own cell excluded, the hit cell last if there is one.
[[nodiscard]] std::vector<WalkCell> cellsOf(const OracleInput& input, int x, int y);

}  // namespace ssrkit
