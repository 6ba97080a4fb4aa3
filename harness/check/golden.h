// Goldens: what a buffer once was, blessed by somebody who had proved it right in another way. They tell that
// something has drifted; what is right is for oracles and closed forms to say (docs/goldens.md).
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/size.h"
#include "check/expectation.h"
#include "check/subject.h"
#include "image/image.h"

namespace ssrkit {

// What changes the bits of a software rasteriser, or of a GPU.
struct GoldenKey {
  std::string rasteriser;  // "llvmpipe": whose goldens may serve another device within a tolerance
  std::string api;         // as the device's identity says
  std::string driver;
  std::string version;
  std::vector<std::string> cpu_features;
  bool operator==(const GoldenKey&) const = default;
};

// "llvmpipe-1f0c52a9": names the file.
[[nodiscard]] std::string keyText(const GoldenKey& key);

// Which buffer of which answer.
struct GoldenSubject {
  std::string test;
  std::string scene;
  Size size;
  std::string stage;  // empty: of the frame
  std::string case_name;
  std::string buffer;  // "hit" or an image
  bool operator==(const GoldenSubject&) const = default;
};

// The sidecar beside the EXR file (docs/formats.md).
struct GoldenNote {
  GoldenSubject subject;
  GoldenKey key;
  std::string who;
  std::string when;  // UTC, ISO 8601
  std::string why;
  std::map<std::string, std::string> hashes;   // "spirv", "scene", "parameters": of what it was made from
  std::map<std::string, std::string> metrics;  // by check: what was measured when it was blessed
};

struct Golden {
  GoldenNote note;
  Image image;  // of a record: the channels of hit.exr
};

// ROOT/TEST/SCENE/WxH/[STAGE.][CASE.]BUFFER.KEY.exr, with .json beside it.
[[nodiscard]] std::filesystem::path goldenFile(const std::filesystem::path& root, const GoldenNote& note);

// Writes both files, each whole or not at all. The sidecar comes last and holds the image's hash, so that a
// pair that does not belong together is noticed.
[[nodiscard]] Expected<void> writeGolden(const std::filesystem::path& root, const Golden& golden);

// Every golden of one test and scene, at all sizes; none is no error. Refused: a sidecar that is damaged or
// of another schema, and an image that is not the one that was blessed.
[[nodiscard]] Expected<std::vector<Golden>> loadGoldens(const std::filesystem::path& root,
                                                        const std::string& test, const std::string& scene);

// The golden of `subject` for a device: one with the very key, or, where `same_rasteriser_will_do`, the first
// of the same rasteriser. Null when none fits.
[[nodiscard]] const Golden* chooseGolden(std::span<const Golden> goldens, const GoldenSubject& subject,
                                         const GoldenKey& key, bool same_rasteriser_will_do);

// Bits are the same only where everything is: a metric that allows no difference needs a golden of the very
// key.
[[nodiscard]] bool sameRasteriserWillDo(const Expectation& expectation);

}  // namespace ssrkit
