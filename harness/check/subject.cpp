#include "check/subject.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/size.h"

namespace ssrkit {

namespace {

struct AnswerKey {
  std::string stage;
  std::string case_name;
  std::string device;
  Size size;
  std::string input;
  std::string variant;      // of a frame's, where no case was named
  bool names_case = false;  // by the truth
  std::string shown_in;
};

AnswerKey keyOf(const Answer& answer) {
  return {answer.stage, answer.case_name, answer.device, answer.size,
          answer.input, answer.variant,   false,         answer.shown_in};
}

// What the frame rendered does not depend on the tracing parameters, but on the job's variant.
bool isFrameOf(const Answer& answer, const AnswerKey& key) {
  return key.names_case ? sharesFrame(answer, key.case_name) : answer.variant == key.variant;
}

const Answer* find(const Subject& subject, const AnswerKey& key) {
  const auto matches = [&](const Answer& answer) {
    const bool same_case = key.stage.empty() ? isFrameOf(answer, key) : answer.case_name == key.case_name;
    return answer.stage == key.stage && same_case && answer.device == key.device && answer.size == key.size &&
           answer.input == key.input && answer.shown_in == key.shown_in;
  };
  const auto found = std::ranges::find_if(subject.pool, matches);
  return found == subject.pool.end() ? nullptr : &*found;
}

}  // namespace

bool sharesFrame(const Answer& frame, const std::string& case_name) {
  return frame.frame_cases.empty() ||
         std::ranges::find(frame.frame_cases, case_name) != frame.frame_cases.end();
}

std::variant<const Answer*, std::string> answerOfTruth(const Subject& subject, const Truth& truth) {
  AnswerKey key = keyOf(*subject.self);
  switch (truth.kind) {
    case TruthKind::kStage:
      key.stage = truth.name;
      break;
    case TruthKind::kCross:
      key.device = truth.name;
      break;
    case TruthKind::kCase:
      key.case_name = truth.name;
      key.names_case = true;
      break;
    case TruthKind::kSize:
      key.size = parseSize(truth.name).value_or(Size{});
      break;
    case TruthKind::kRendered:
      key.input.clear();
      break;
    case TruthKind::kGolden:
      if (subject.golden != nullptr) {
        return subject.golden;
      }
      return fmt::format("no golden fits {}", subject.self->device);
    case TruthKind::kNone:
    case TruthKind::kOracle:
    case TruthKind::kGeometry:
    case TruthKind::kClosedForm:
      return fmt::format("'{}' is no answer of a tracer", truthText(truth));
  }
  if (const Answer* found = find(subject, key)) {
    return found;
  }
  return fmt::format("there is no answer of {} to compare with (stage '{}', device '{}', {}, case '{}')",
                     truthText(truth), key.stage, key.device, sizeText(key.size), key.case_name);
}

const Answer* answerOfCase(const Subject& subject, const std::string& case_name) {
  AnswerKey key = keyOf(*subject.self);
  key.case_name = case_name;
  return find(subject, key);
}

}  // namespace ssrkit
