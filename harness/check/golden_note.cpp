#include "check/golden_note.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "base/json_text.h"
#include "base/size.h"

namespace ssrkit {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kSchema = "ssrkit-golden";
constexpr std::array<const char*, 16> kGoldenNoteKeys = {
    "schema", "schema_version", "test", "scene",  "size",    "stage",    "case", "buffer", "key",
    "who",    "when",           "why",  "hashes", "metrics", "channels", "image"};

Json keyJson(const GoldenKey& key) {
  return {{"rasteriser", key.rasteriser},
          {"api", key.api},
          {"driver", key.driver},
          {"version", key.version},
          {"cpu_features", key.cpu_features}};
}

GoldenKey keyFrom(const Json& json) {
  return {.rasteriser = json.at("rasteriser"),
          .api = json.at("api"),
          .driver = json.at("driver"),
          .version = json.at("version"),
          .cpu_features = json.at("cpu_features").get<std::vector<std::string>>()};
}

StoredGolden storedFrom(const Json& json) {
  StoredGolden stored;
  GoldenSubject& subject = stored.note.subject;
  json.at("test").get_to(subject.test);
  json.at("scene").get_to(subject.scene);
  subject.size = parseSize(json.at("size").get<std::string>()).value_or(Size{});
  json.at("stage").get_to(subject.stage);
  json.at("case").get_to(subject.case_name);
  json.at("buffer").get_to(subject.buffer);
  stored.note.key = keyFrom(json.at("key"));
  json.at("who").get_to(stored.note.who);
  json.at("when").get_to(stored.note.when);
  json.at("why").get_to(stored.note.why);
  json.at("hashes").get_to(stored.note.hashes);
  json.at("metrics").get_to(stored.note.metrics);
  json.at("channels").get_to(stored.channels);
  json.at("image").get_to(stored.image_hash);
  return stored;
}

// The first key that no sidecar has; "" when there is none.
std::string unknownKey(const Json& json) {
  for (const auto& [key, value] : json.items()) {
    if (std::ranges::find(kGoldenNoteKeys, key) == kGoldenNoteKeys.end()) {
      return key;
    }
  }
  return "";
}

}  // namespace

std::string goldenNoteText(const StoredGolden& stored) {
  const GoldenSubject& subject = stored.note.subject;
  const Json json = {{"schema", kSchema},
                     {"schema_version", kGoldenSchemaVersion},
                     {"test", subject.test},
                     {"scene", subject.scene},
                     {"size", sizeText(subject.size)},
                     {"stage", subject.stage},
                     {"case", subject.case_name},
                     {"buffer", subject.buffer},
                     {"key", keyJson(stored.note.key)},
                     {"who", stored.note.who},
                     {"when", stored.note.when},
                     {"why", stored.note.why},
                     {"hashes", stored.note.hashes},
                     {"metrics", stored.note.metrics},
                     {"channels", stored.channels},
                     {"image", stored.image_hash}};
  return jsonText(json, 1) + "\n";
}

Expected<StoredGolden> parseGoldenNote(std::string_view text, const std::string& file) try {
  const std::string attempted = fmt::format("read the golden's sidecar '{}'", file);
  const Json json = Json::parse(text);
  if (json.value("schema", "") != kSchema || json.value("schema_version", 0) != kGoldenSchemaVersion) {
    return inputError(attempted, fmt::format("its schema is not {} {}", kSchema, kGoldenSchemaVersion), file,
                      "bless the buffer again");
  }
  if (const std::string key = unknownKey(json); !key.empty()) {
    return inputError(attempted, fmt::format("no golden has a key '{}'", key), file);
  }
  StoredGolden stored = storedFrom(json);
  if (stored.note.subject.size == Size{} || stored.channels.empty()) {
    return inputError(attempted, "its size or channels are none", file, "bless the buffer again");
  }
  return stored;
} catch (const nlohmann::json::exception& exception) {
  return inputError(fmt::format("read the golden's sidecar '{}'", file), exception.what(), file,
                    "restore the file, or bless the buffer again");
}

}  // namespace ssrkit
