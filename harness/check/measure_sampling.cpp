// Over- and undersampling: how often a march looks at a texel again, and how many it jumps over.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "check/march_samples.h"
#include "check/measure.h"
#include "check/ray_pairs.h"

namespace ssrkit {

namespace {

// More hits than this whose last sample is not where the record says: the shader does not step as its stage's
// name says. Single precision alone parts a sample on a texel's edge from the double one.
constexpr double kMostStraySamples = 0.01;

constexpr std::array<const char*, 7> kBins = {"again",     "1 on",       "2 on",         "3 to 4 on",
                                              "5 to 8 on", "9 to 16 on", "17 or more on"};

// The bin of a move by this many texels along the longer axis: doubling ranges.
std::size_t binOf(int moved) {
  return moved < 3
             ? static_cast<std::size_t>(moved)
             : std::min(kBins.size() - 1, 2 + static_cast<std::size_t>(std::ceil(std::log2(moved / 2.0))));
}

int movedTexels(glm::ivec2 from, glm::ivec2 to) {
  return std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
}

struct Sampling {
  std::size_t rays = 0;
  std::size_t samples = 0;
  std::size_t again = 0;    // samples in the texel of the sample before
  std::size_t moved = 0;    // texels from sample to sample along the longer axis, summed
  std::size_t skipped = 0;  // texels between two samples that neither fell in
  std::size_t hits = 0;
  std::size_t stray = 0;  // hits that are not where the last sample is
  std::array<std::size_t, kBins.size()> moves{};
};

void addRay(glm::ivec2 own, const std::vector<glm::ivec2>& texels, const RayHit& hit, Sampling& sampling) {
  glm::ivec2 before = own;
  int last_move = 0;
  for (const glm::ivec2 texel : texels) {
    last_move = movedTexels(before, texel);
    ++sampling.samples;
    ++sampling.moves.at(binOf(last_move));
    sampling.again += last_move == 0 ? 1U : 0U;
    sampling.moved += static_cast<std::size_t>(last_move);
    sampling.skipped += static_cast<std::size_t>(std::max(0, last_move - 1));
    before = texel;
  }
  ++sampling.rays;
  if (hit.ray_class == RayClass::kHit && !texels.empty()) {
    // Refinement goes back by less than a step; the middle of an even stride is an edge between two texels.
    const int reach = std::max(1, hit.steps > texels.size() ? last_move : 0);
    ++sampling.hits;
    sampling.stray += movedTexels(before, {hit.texel_x, hit.texel_y}) > reach ? 1U : 0U;
  }
}

Sampling samplingOf(const Answer& answer, MarchSpacing spacing) {
  Sampling sampling;
  const PixelProjection projection = pixelProjection(*answer.oracle_input->camera);
  for (int y = 0; y < answer.size.height; ++y) {
    for (int x = 0; x < answer.size.width; ++x) {
      const RayHit& hit = answer.record->at(x, y);
      if (hasNoRay(hit.ray_class)) {
        continue;
      }
      const PixelRay pixel = pixelRay(*answer.oracle_input, projection, x, y);
      if (pixel.is_walked) {
        addRay(glm::ivec2(glm::floor(pixel.ray.px_origin)),
               marchSamples(spacing, pixel.ray, answer.parameters, hit), hit, sampling);
      }
    }
  }
  return sampling;
}

double share(std::size_t part, std::size_t whole) {
  return static_cast<double>(part) / std::max(1.0, static_cast<double>(whole));
}

std::string problemWith(const Answer& answer) {
  if (std::string problem = problemWithRecord(answer); !problem.empty()) {
    return problem;
  }
  if (!marchSpacing(answer.stage)) {
    return fmt::format("the samples of the stage '{}' are not evenly spaced", answer.stage);
  }
  if (answer.parameters.jitter > 0.0) {
    return "with jitter the samples' places are not known";
  }
  return answer.oracle_input == nullptr ? "the oracle's input is not known" : "";
}

}  // namespace

Measurement measureSampling(const Expectation& expectation, const Subject& subject) {
  const Answer& self = *subject.self;
  if (std::string problem = problemWith(self); !problem.empty()) {
    return cannotMeasure(std::move(problem));
  }
  const Sampling sampling = samplingOf(self, *marchSpacing(self.stage));
  if (share(sampling.stray, sampling.hits) > kMostStraySamples) {
    return cannotMeasure(fmt::format(
        "{} of {} hits are not where the last sample of the march '{}' would be: its shader steps "
        "otherwise than the contract says",
        sampling.stray, sampling.hits, self.stage));
  }
  Measurement measurement;
  measurement.compared = sampling.rays;
  const double again = share(sampling.again, sampling.samples);
  const double skipped = share(sampling.skipped, sampling.moved);
  measurement.value = expectation.metric == Metric::kResampledShare ? again : skipped;
  measurement.remark = fmt::format(
      "{} samples: {:.3g} % in the texel of the sample before; {:.3g} % of {} texels on their way jumped "
      "over",
      sampling.samples, 100.0 * again, 100.0 * skipped, sampling.moved);
  for (std::size_t bin = 0; bin < kBins.size(); ++bin) {
    measurement.histogram.push_back({kBins.at(bin), sampling.moves.at(bin)});
  }
  return measurement;
}

}  // namespace ssrkit
