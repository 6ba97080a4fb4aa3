#include "check/golden.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "base/atomic_file.h"
#include "base/hash128.h"
#include "base/size.h"
#include "check/golden_note.h"
#include "image/exr.h"

namespace ssrkit {

namespace {

std::string plainWord(std::string_view text) {
  std::string word;
  for (const char letter : text) {
    const bool is_plain =
        (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9') || letter == '-';
    word += is_plain ? letter : '_';
  }
  return word;
}

Expected<Golden> loadGolden(const std::filesystem::path& sidecar) {
  const std::string attempted = fmt::format("read the golden '{}'", sidecar.string());
  const std::filesystem::path file = std::filesystem::path(sidecar).replace_extension(".exr");
  const auto text = readFile(sidecar);
  const auto bytes = text ? readFile(file) : tl::make_unexpected(text.error());
  if (!bytes) {
    return tl::make_unexpected(bytes.error());
  }
  auto stored = parseGoldenNote(*text, sidecar.string());
  if (!stored) {
    return tl::make_unexpected(stored.error());
  }
  if (stored->image_hash != hashName(*bytes)) {
    return inputError(attempted, "its image is not the one that was blessed", file.string(),
                      "restore both files, or bless the buffer again");
  }
  auto image = readExr(file, {.channels = stored->channels, .size = stored->note.subject.size});
  if (!image) {
    return tl::make_unexpected(image.error());
  }
  return Golden{.note = std::move(stored->note), .image = std::move(*image)};
}

}  // namespace

std::string keyText(const GoldenKey& key) {
  constexpr std::size_t kDigits = 8;
  const std::string all =
      fmt::format("{}\n{}\n{}\n{}", key.api, key.driver, key.version, fmt::join(key.cpu_features, " "));
  return plainWord(key.rasteriser) + "-" + hashName(all).substr(0, kDigits);
}

std::filesystem::path goldenFile(const std::filesystem::path& root, const GoldenNote& note) {
  const GoldenSubject& subject = note.subject;
  std::string name;
  for (const std::string* part : {&subject.stage, &subject.case_name}) {
    name += part->empty() ? "" : *part + ".";
  }
  name += fmt::format("{}.{}.exr", subject.buffer, keyText(note.key));
  return root / subject.test / subject.scene / sizeText(subject.size) / name;
}

Expected<void> writeGolden(const std::filesystem::path& root, const Golden& golden) {
  const std::filesystem::path file = goldenFile(root, golden.note);
  return writeExr(file, golden.image)
      .and_then([&] { return readFile(file); })
      .and_then([&](const std::string& bytes) {
        const StoredGolden stored{
            .note = golden.note, .channels = golden.image.channels, .image_hash = hashName(bytes)};
        return writeFileAtomically(std::filesystem::path(file).replace_extension(".json"),
                                   goldenNoteText(stored));
      });
}

Expected<std::vector<Golden>> loadGoldens(const std::filesystem::path& root, const std::string& test,
                                          const std::string& scene) {
  const std::filesystem::path folder = root / test / scene;
  std::vector<std::filesystem::path> sidecars;
  std::error_code failure;
  for (std::filesystem::recursive_directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    if (entry->path().extension() == ".json") {
      sidecars.push_back(entry->path());
    }
  }
  if (failure && failure != std::errc::no_such_file_or_directory) {
    return inputError("read the goldens", failure.message(), folder.string());
  }
  std::ranges::sort(sidecars);
  std::vector<Golden> goldens;
  for (const std::filesystem::path& sidecar : sidecars) {
    auto golden = loadGolden(sidecar);
    if (!golden) {
      return tl::make_unexpected(golden.error());
    }
    goldens.push_back(std::move(*golden));
  }
  return goldens;
}

const Golden* chooseGolden(std::span<const Golden> goldens, const GoldenSubject& subject,
                           const GoldenKey& key, bool same_rasteriser_will_do) {
  const Golden* chosen = nullptr;
  for (const Golden& golden : goldens) {
    if (!(golden.note.subject == subject)) {
      continue;
    }
    if (golden.note.key == key) {
      return &golden;
    }
    const bool is_kin = same_rasteriser_will_do && golden.note.key.rasteriser == key.rasteriser;
    chosen = chosen == nullptr && is_kin ? &golden : chosen;
  }
  return chosen;
}

bool sameRasteriserWillDo(const Expectation& expectation) {
  return expectation.metric != Metric::kIdentical;
}

}  // namespace ssrkit
