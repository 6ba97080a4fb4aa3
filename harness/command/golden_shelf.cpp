#include "command/golden_shelf.h"

#include <algorithm>
#include <utility>

#include "device/registry.h"

namespace ssrkit {

GoldenKey goldenKeyOf(const DeviceIdentity& identity) {
  const auto entry = findDevice(identity.id);
  return {.rasteriser = entry ? (*entry)->rasteriser : identity.driver,
          .api = identity.api,
          .driver = identity.driver,
          .version = identity.version,
          .cpu_features = identity.cpu_features};
}

GoldenSubject goldenSubjectOf(const std::string& test, const std::string& scene,
                              const Expectation& expectation, const Answer& answer) {
  return {.test = test,
          .scene = scene,
          .size = answer.size,
          .stage = answer.stage,
          .case_name = answer.case_name,
          .buffer = expectation.buffer};
}

Expected<GoldenShelf> GoldenShelf::load(const std::filesystem::path& root, const TestFile& test,
                                        const std::string& scene) {
  GoldenShelf shelf;
  shelf.test_ = test.id;
  shelf.scene_ = scene;
  const bool asks_for_any = std::ranges::any_of(test.expectations, [](const Expectation& expectation) {
    return expectation.truth.kind == TruthKind::kGolden;
  });
  auto goldens = asks_for_any ? loadGoldens(root, test.id, scene) : Expected<std::vector<Golden>>();
  if (!goldens) {
    return tl::make_unexpected(goldens.error());
  }
  for (const Golden& golden : *goldens) {
    if (golden.note.subject.buffer == "hit") {
      // Whether it is a record at all is told once, here.
      auto record = rayRecordFromImage(golden.image, goldenFile(root, golden.note).string());
      if (!record) {
        return tl::make_unexpected(record.error());
      }
    }
  }
  shelf.goldens_ = std::move(*goldens);
  return shelf;
}

const Answer* GoldenShelf::find(const Expectation& expectation, const Answer& answer, const GoldenKey& key) {
  const Golden* const golden = chooseGolden(goldens_, goldenSubjectOf(test_, scene_, expectation, answer),
                                            key, sameRasteriserWillDo(expectation));
  if (golden == nullptr) {
    return nullptr;
  }
  Answer blessed{};
  blessed.device = "golden";
  blessed.stage = answer.stage;
  blessed.case_name = answer.case_name;
  blessed.size = answer.size;
  blessed.parameters = answer.parameters;
  if (expectation.buffer == "hit") {
    auto record = rayRecordFromImage(golden->image, "");
    if (!record) {
      return nullptr;
    }
    blessed.record = &records_.emplace_back(std::move(*record));
  } else {
    blessed.images.emplace(expectation.buffer, &golden->image);
  }
  return &answers_.emplace_back(std::move(blessed));
}

}  // namespace ssrkit
