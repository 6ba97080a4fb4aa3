#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include "base/atomic_file.h"
#include "base/text.h"
#include "check/field_reader.h"
#include "check/toml_document.h"
#include "command/bench_work.h"
#include "frame/frame_images.h"
#include "frame/stages.h"

namespace ssrkit {

namespace {

// In the order of the enumerations of frame/peer.h.
const std::vector<std::string> kDepths = {"dist_view", "view_z", "window", "window_reversed", "linear01"};
const std::vector<std::string> kMips = {"none", "nearest", "farthest"};
const std::vector<std::string> kNormals = {"signed", "unsigned", "forward"};
const std::vector<std::string> kAnswers = {"uv", "uv_upwards", "texel", "mask"};
const std::vector<std::string> kChannels = {"x", "y", "z", "w"};

int placeOf(const std::vector<std::string>& words, const std::string& word) {
  return static_cast<int>(std::ranges::find(words, word) - words.begin());
}

// One file under reading.
struct PeerFile {
  const TomlValue& document;
  std::string name;
  std::string attempted;

  // The section's table; an empty one when it is not there.
  [[nodiscard]] const TomlValue& section(const char* key) const {
    static const TomlValue none{.place = {1, 1}};
    const TomlEntry* const entry = document.find(key);
    return entry == nullptr ? none : entry->value;
  }
  [[nodiscard]] FieldReader reader(const char* key) const {
    return {section(key), fmt::format("[{}]", key), name, attempted};
  }
};

Expected<void> checkSections(const PeerFile& file) {
  static const std::vector<std::string> kSections = {"peer", "reads", "images", "values", "answer"};
  for (const TomlEntry& entry : file.document.entries) {
    const bool is_known = std::ranges::find(kSections, entry.key) != kSections.end();
    if (!is_known || entry.value.kind != TomlValue::Kind::kTable) {
      return inputError(file.attempted, fmt::format("'{}' is no section of a peer's file", entry.key),
                        placeText(file.name, entry.key_place), "its sections are " + joinNames(kSections));
    }
  }
  return {};
}

// One of `words`, by its place among them; the first without the key.
int choice(FieldReader& fields, const char* key, const std::vector<std::string>& words) {
  const std::string word = fields.optionalText(key).value_or(words.front());
  fields.requireKnown(key, word, key, words);
  return placeOf(words, word);
}

Expected<void> readPeerSection(const PeerFile& file, PeerShader& peer) {
  FieldReader fields = file.reader("peer");
  static const std::vector<std::string> kKeys = {"name", "shader", "about"};
  fields.allowOnly(kKeys);
  peer.name = fields.text("name");
  fields.requirePlainId("name", peer.name);
  if (fields.ok() && findStage(peer.name)) {
    fields.complain("name", fmt::format("'{}' is one of the kit's own stages", peer.name),
                    "choose another name");
  }
  static_cast<void>(fields.optionalText("about"));
  peer.file =
      std::filesystem::absolute(std::filesystem::path(file.name).parent_path() / fields.text("shader"));
  return fields.result();
}

Expected<void> readConventions(const PeerFile& file, PeerShader& peer) {
  FieldReader reads = file.reader("reads");
  static const std::vector<std::string> kReads = {"depth", "mips", "normal"};
  reads.allowOnly(kReads);
  peer.depth = static_cast<PeerDepth>(choice(reads, "depth", kDepths));
  peer.mips = static_cast<PeerMips>(choice(reads, "mips", kMips));
  peer.normal = static_cast<PeerNormal>(choice(reads, "normal", kNormals));
  if (!reads.ok()) {
    return reads.result();
  }
  FieldReader answer = file.reader("answer");
  static const std::vector<std::string> kKeys = {"is", "hit", "lookups"};
  answer.allowOnly(kKeys);
  peer.answer = static_cast<PeerAnswer>(choice(answer, "is", kAnswers));
  const std::string hit = answer.text("hit");
  answer.requireKnown("hit", hit, "channel", kChannels);
  peer.hit_channel = placeOf(kChannels, hit);
  if (const auto lookups = answer.optionalText("lookups")) {
    answer.requireKnown("lookups", *lookups, "channel", kChannels);
    peer.lookups_channel = placeOf(kChannels, *lookups);
  }
  return answer.result();
}

Expected<void> readImages(const PeerFile& file, PeerShader& peer) {
  std::vector<std::string> known = {"depth", "normal"};
  for (const FrameImageRow& row : frameImages()) {
    if (!row.folder.empty()) {
      known.push_back(row.name);
    }
  }
  FieldReader fields = file.reader("images");
  for (const TomlEntry& entry : file.section("images").entries) {
    const std::string image = fields.text(entry.key);
    fields.requireKnown(entry.key, image, "image", known);
    peer.images.emplace(entry.key, image);
  }
  return fields.result();
}

tl::unexpected<Error> wrongValue(const PeerFile& file, const TomlEntry& entry, const std::string& problem,
                                 const std::string& remedy) {
  return inputError(file.attempted, fmt::format("'{}' is {}", entry.key, problem),
                    placeText(file.name, entry.value.place), remedy);
}

Expected<void> readValues(const PeerFile& file, PeerShader& peer) {
  for (const TomlEntry& entry : file.section("values").entries) {
    switch (entry.value.kind) {
      case TomlValue::Kind::kText:
        peer.values.emplace(entry.key, entry.value.text);
        break;
      case TomlValue::Kind::kInteger:
        if (!std::in_range<int>(entry.value.integer)) {
          return wrongValue(file, entry, std::to_string(entry.value.integer),
                            "whole numbers go from -2147483648 to 2147483647");
        }
        peer.constants.emplace(entry.key, static_cast<int>(entry.value.integer));
        break;
      case TomlValue::Kind::kFloat:
        peer.constants.emplace(entry.key, entry.value.number);
        break;
      default:
        return wrongValue(file, entry, name(entry.value.kind),
                          "write the name of one of the kit's values, or a number");
    }
  }
  return {};
}

Expected<PeerShader> readPeer(const std::filesystem::path& path) {
  const std::string attempted = fmt::format("read the peer '{}'", path.string());
  const Expected<std::string> content = readFile(path);
  const auto document =
      content ? parseToml(*content, path.string(), attempted) : tl::make_unexpected(content.error());
  if (!document) {
    return tl::make_unexpected(document.error());
  }
  const PeerFile file{*document, path.string(), attempted};
  PeerShader peer;
  auto read = checkSections(file);
  read = read ? readPeerSection(file, peer) : read;
  read = read ? readConventions(file, peer) : read;
  read = read ? readImages(file, peer) : read;
  read = read ? readValues(file, peer) : read;
  return read ? Expected<PeerShader>(std::move(peer)) : tl::make_unexpected(read.error());
}

}  // namespace

Expected<std::vector<PeerShader>> readPeers(const BenchOptions& options) {
  std::vector<PeerShader> peers;
  for (const std::filesystem::path& file : options.peers) {
    auto peer = readPeer(file);
    if (!peer) {
      return tl::make_unexpected(peer.error());
    }
    if (std::ranges::find(peers, peer->name, &PeerShader::name) != peers.end()) {
      return inputError("bench", fmt::format("two peers are called '{}'", peer->name), file.string(),
                        "give each its own name");
    }
    peers.push_back(std::move(*peer));
  }
  return peers;
}

}  // namespace ssrkit
