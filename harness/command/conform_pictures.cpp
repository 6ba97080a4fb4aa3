#include "command/conform_pictures.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "image/colour_map.h"
#include "image/png.h"
#include "report/canvas.h"
#include "report/verdict_colours.h"

namespace ssrkit {

namespace {

constexpr int kPictureWidthDots = 640;  // dots, at least half of them

const Answer* find(const SceneRun& run, const CheckResult& check, const std::string& device,
                   const std::string& input) {
  const auto found = std::ranges::find_if(run.answers, [&](const Answer& answer) {
    return answer.device == device && answer.stage == check.stage && answer.input == input &&
           (check.stage.empty() || answer.case_name == check.case_name);
  });
  return found == run.answers.end() ? nullptr : &*found;
}

bool isSameRay(const RayHit& a, const RayHit& b) {
  return a.ray_class == b.ray_class && a.texel_x == b.texel_x && a.texel_y == b.texel_y;
}

ByteImage rayPicture(const Answer& answer, const Answer* truth) {
  ByteImage picture(answer.size, 3);
  const std::vector<Verdict> verdicts =
      answer.oracle != nullptr ? compareWithOracle(*answer.record, *answer.oracle, *answer.oracle_input)
                               : std::vector<Verdict>(answer.record->rays.size(), Verdict::kNone);
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    const bool differs = truth != nullptr && truth->record != nullptr &&
                         !isSameRay(answer.record->rays[i], truth->record->rays[i]);
    const bool is_well = verdicts[i] == Verdict::kSame || verdicts[i] == Verdict::kNone;
    const Rgb8 colour = differs && is_well ? Rgb8{255, 255, 255} : colourOf(verdicts[i]);
    std::ranges::copy(colour, picture.data.begin() + static_cast<std::ptrdiff_t>(3 * i));
  }
  return picture;
}

// The worst channel's difference, relative to the truth's value where that is over 1.
double difference(const Image& image, const Image& truth, std::size_t texel) {
  double worst = 0.0;
  const std::size_t channels = image.channelCount();
  for (std::size_t c = texel * channels; c < (texel + 1) * channels; ++c) {
    const double a = image.data[c];
    const double b = truth.data[c];
    const bool is_same = a == b || (std::isnan(a) && std::isnan(b));
    const double relative = std::abs(a - b) / std::max(1.0, std::abs(b));
    worst = is_same ? worst : std::isfinite(relative) ? std::max(worst, relative) : 1.0;
  }
  return worst;
}

ByteImage differencePicture(const Image& image, const Image& truth) {
  constexpr double kDecades = 8.0;
  ByteImage picture(image.size, 3);
  for (std::size_t texel = 0; texel < image.texelCount(); ++texel) {
    const double size = difference(image, truth, texel);
    const Rgb8 colour = size > 0.0 ? sequentialColour(1.0 + std::log10(size) / kDecades) : okabe_ito::kBlack;
    std::ranges::copy(colour, picture.data.begin() + static_cast<std::ptrdiff_t>(3 * texel));
  }
  return picture;
}

ByteImage enlarged(const ByteImage& picture) {
  const int grow = std::max(1, kPictureWidthDots / picture.size.width);
  ByteImage large({picture.size.width * grow, picture.size.height * grow}, 3);
  paste(large, 0, 0, picture, grow);
  return large;
}

std::optional<ByteImage> pictureOf(const Expectation& expectation, const Answer& answer,
                                   const Answer* truth) {
  if (expectation.buffer == "hit") {
    return answer.record != nullptr ? std::optional(rayPicture(answer, truth)) : std::nullopt;
  }
  const auto image = answer.images.find(expectation.buffer);
  if (truth == nullptr || image == answer.images.end()) {
    return std::nullopt;
  }
  const auto other = truth->images.find(expectation.buffer);
  const bool can_compare = other != truth->images.end() && other->second->size == image->second->size &&
                           other->second->channelCount() == image->second->channelCount();
  return can_compare ? std::optional(differencePicture(*image->second, *other->second)) : std::nullopt;
}

}  // namespace

Expected<void> writeFailurePictures(const TestFile& test, const Cell& cell, const SceneRun& run,
                                    const CellStore& store) {
  std::set<std::string> written;
  for (const CheckResult& check : run.checks) {
    const auto expectation = std::ranges::find_if(
        test.expectations, [&](const Expectation& asked) { return check.id == test.id + "." + asked.name; });
    const Answer* const answer = find(run, check, cell.device, test.input);
    if (check.device != cell.device || !isFailure(check.outcome) || expectation == test.expectations.end() ||
        answer == nullptr) {
      continue;
    }
    const bool is_crossed = expectation->truth.kind == TruthKind::kCross;
    const Answer* const truth = is_crossed ? find(run, check, expectation->truth.name, test.input) : nullptr;
    const auto picture = pictureOf(*expectation, *answer, truth);
    std::string label = expectation->buffer;
    for (const std::string& part : {check.stage, check.case_name}) {
      label += part.empty() ? "" : "." + part;
    }
    if (picture && written.insert(label).second) {
      if (auto done = writePng(store.pictureOf(cellId(cell), label), enlarged(*picture)); !done) {
        return done;
      }
    }
  }
  return {};
}

}  // namespace ssrkit
