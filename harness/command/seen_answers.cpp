#include "command/seen_answers.h"

#include "base/check.h"
#include "frame/variants.h"
#include "oracle/image_ray.h"

namespace ssrkit {

namespace {

ViewChange viewOf(const std::string& variant) {
  const auto row = findVariant(variant);
  SSRKIT_CHECK(row.has_value());  // the file that names it has been read
  return (*row)->view;
}

// A ray that its range ended in the whole picture may have left the crop before: then it is OFFSCREEN there.
// The oracle's input says where it ended.
void endAtCrop(const OracleInput& input, RayRecord& seen) {
  const Crop crop = cropOf(input.dist_view->size);
  const PixelProjection projection = pixelProjection(*input.camera);
  for (int y = 0; y < crop.size.height; ++y) {
    for (int x = 0; x < crop.size.width; ++x) {
      RayHit& hit = seen.rays[static_cast<std::size_t>(y) * static_cast<std::size_t>(crop.size.width) +
                              static_cast<std::size_t>(x)];
      if (hit.ray_class != RayClass::kRange) {
        continue;
      }
      const ImageRay ray = pixelRay(input, projection, crop.x + x, crop.y + y).ray;
      const glm::dvec2 end = ray.pxAt(ray.sigma_end) - glm::dvec2(crop.x, crop.y);
      const bool is_inside =
          end.x >= 0.0 && end.y >= 0.0 && end.x < crop.size.width && end.y < crop.size.height;
      hit.ray_class = is_inside ? RayClass::kRange : RayClass::kOffscreen;
    }
  }
}

Answer seenIn(const std::string& variant, const Answer& plain, SeenAnswer& owner) {
  const ViewChange view = viewOf(variant);
  Answer seen;
  seen.stage = plain.stage;
  seen.case_name = plain.case_name;
  seen.device = plain.device;
  seen.input = plain.input;
  seen.frame_cases = plain.frame_cases;
  seen.size = sizeIn(view, plain.size);
  seen.shown_in = variant;
  seen.is_made = true;
  if (plain.record != nullptr) {
    owner.record = recordIn(view, *plain.record);
    if (view.is_cropped && plain.oracle_input != nullptr) {
      endAtCrop(*plain.oracle_input, owner.record);
    }
    seen.record = &owner.record;
  }
  for (const auto& [name, image] : plain.images) {
    seen.images.emplace(name, &owner.images.emplace(name, imageIn(view, name, *image)).first->second);
  }
  return seen;
}

}  // namespace

bool changesView(const std::string& variant) {
  return viewOf(variant) != ViewChange{};
}

void addSeenAnswers(const std::vector<std::string>& variants, std::deque<SeenAnswer>& owned,
                    std::vector<Answer>& answers) {
  const std::size_t count = answers.size();
  for (const std::string& variant : variants) {
    for (std::size_t i = 0; changesView(variant) && i < count; ++i) {
      if (answers[i].variant.empty()) {
        answers.push_back(seenIn(variant, Answer(answers[i]), owned.emplace_back()));
      }
    }
  }
}

}  // namespace ssrkit
