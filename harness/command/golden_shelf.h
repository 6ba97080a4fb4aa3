// The goldens of one test and scene, as answers that checks are held against.
#pragma once

#include <deque>
#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"
#include "check/golden.h"
#include "check/subject.h"
#include "device/device.h"
#include "image/ray_record.h"

namespace ssrkit {

// What a golden of a device must have been made with.
[[nodiscard]] GoldenKey goldenKeyOf(const DeviceIdentity& identity);

// Which golden an expectation of `test` asks for, of an answer over `scene`.
[[nodiscard]] GoldenSubject goldenSubjectOf(const std::string& test, const std::string& scene,
                                            const Expectation& expectation, const Answer& answer);

class GoldenShelf {
 public:
  // `root` is the folder of all goldens. Empty where the test asks for none; fails on a golden that is
  // damaged.
  [[nodiscard]] static Expected<GoldenShelf> load(const std::filesystem::path& root, const TestFile& test,
                                                  const std::string& scene);

  // The golden for an answer of a device with `key`; null when none fits. It lives as long as the shelf.
  [[nodiscard]] const Answer* find(const Expectation& expectation, const Answer& answer,
                                   const GoldenKey& key);

  [[nodiscard]] const std::vector<Golden>& goldens() const { return goldens_; }

 private:
  std::string test_;
  std::string scene_;
  std::vector<Golden> goldens_;
  std::deque<RayRecord> records_;
  std::deque<Answer> answers_;
};

}  // namespace ssrkit
