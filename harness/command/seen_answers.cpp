#include "command/seen_answers.h"

#include "base/check.h"
#include "frame/variants.h"

namespace ssrkit {

namespace {

ViewChange viewOf(const std::string& variant) {
  const auto row = findVariant(variant);
  SSRKIT_CHECK(row.has_value());  // the file that names it has been read
  return (*row)->view;
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
