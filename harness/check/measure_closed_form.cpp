#include <fmt/format.h>

#include <memory>
#include <utility>

#include "check/measure.h"
#include "check/ray_pairs.h"
#include "oracle/closed_form.h"

namespace ssrkit {

namespace {

// What the formula says of the decided pixels, as a record that other parts can read. Its positions and times
// are only as good as the formula's; `lookups` is the number of cells walked to a hit.
RayHit expectedHit(const ExpectedRay& expected) {
  RayHit hit;
  hit.ray_class = *expected.ray_class;
  hit.texel_x = expected.texel.x;
  hit.texel_y = expected.texel.y;
  hit.px_x = static_cast<float>(expected.px.x);
  hit.px_y = static_cast<float>(expected.px.y);
  hit.lookups = expected.lookups < 0 ? 0U : static_cast<std::uint32_t>(expected.lookups);
  return hit;
}

}  // namespace

Measurement measureClosedForm(const Expectation& expectation, const Subject& subject) {
  const Answer& self = *subject.self;
  const ClosedForm* form = findClosedForm(subject.scene);
  if (form == nullptr) {
    return cannotMeasure(fmt::format("the scene '{}' has no closed form", subject.scene));
  }
  if (std::string problem = problemWithRecord(self); !problem.empty()) {
    return cannotMeasure(std::move(problem));
  }
  const bool of_lookups = expectation.metric == Metric::kClosedFormLookups;
  auto formula =
      std::make_shared<RayRecord>(RayRecord{self.size, std::vector<RayHit>(self.record->rays.size())});
  RayPairs pairs;
  pairs.expected = formula.get();
  std::vector<RayPair> differing;
  std::size_t undecided = 0;
  std::size_t index = 0;
  for (int y = 0; y < self.size.height; ++y) {
    for (int x = 0; x < self.size.width; ++x, ++index) {
      const ExpectedRay expected = form->expected(self.size, self.parameters, x, y);
      if (!expected.ray_class || (of_lookups && expected.lookups < 0)) {
        ++undecided;
        continue;
      }
      formula->rays[index] = expectedHit(expected);
      const RayPair pair{x, y, &self.record->rays[index], &formula->rays[index]};
      pairs.pairs.push_back(pair);
      const bool agrees = sameAnswer(*pair.yours, *pair.expected) &&
                          (!of_lookups || pair.yours->lookups == pair.expected->lookups);
      if (!agrees) {
        differing.push_back(pair);
      }
    }
  }
  Measurement measurement = findingsOf(std::move(pairs), std::move(differing), subject);
  measurement.value = static_cast<double>(measurement.findings.size());
  measurement.compared_what = "pixels";
  measurement.remark = fmt::format("{}; {} pixels are not decided by it", form->formula, undecided);
  measurement.describe = [formula, describe = measurement.describe, of_lookups,
                          record = self.record](const Finding& finding) {
    FindingText text = describe(finding);
    if (of_lookups) {
      text.yours += fmt::format(" after {} lookups", record->at(finding.x, finding.y).lookups);
      text.expected += fmt::format(" after {} lookups", formula->at(finding.x, finding.y).lookups);
    }
    return text;
  };
  measurement.cause = [formula, cause = measurement.cause] { return cause(); };
  return measurement;
}

}  // namespace ssrkit
