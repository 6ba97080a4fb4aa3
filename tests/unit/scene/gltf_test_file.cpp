#include "gltf_test_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <fstream>
#include <string_view>
#include <system_error>

namespace ssrkit::test {

namespace fs = std::filesystem;
using nlohmann::json;

ScratchFolder::ScratchFolder() {
  static std::atomic<int> counter{0};
  path_ = fs::temp_directory_path() / fmt::format("ssrkit-scene-test-{}-{}", getpid(), counter++);
  fs::create_directories(path_);
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

fs::path ScratchFolder::write(const std::string& name, const std::string& content) const {
  const fs::path file = path_ / name;
  std::ofstream(file, std::ios::binary) << content;
  return file;
}

std::string dataUri(const std::vector<std::uint8_t>& bytes) {
  constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text = "data:application/octet-stream;base64,";
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8U | (i + k < bytes.size() ? bytes[i + k] : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k <= bytes.size() ? kAlphabet[group >> (18U - 6U * k) & 63U] : '=';
    }
  }
  return text;
}

json triangleFile() {
  json root = {{"asset", {{"version", "2.0"}}},
               {"scene", 0},
               {"scenes", {{{"nodes", {0}}}}},
               {"nodes", {{{"mesh", 0}}}},
               {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}}}}}};
  addAccessor(root, bytesOf<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}), kFloat, 3, "VEC3");
  addAccessor(root, bytesOf<std::uint16_t>({0, 1, 2}), kUnsignedShort, 3, "SCALAR");
  return root;
}

json& primitiveOf(json& root) {
  return root["meshes"][0]["primitives"][0];
}

int addView(json& root, const std::vector<std::uint8_t>& bytes) {
  root["buffers"].push_back({{"byteLength", bytes.size()}, {"uri", dataUri(bytes)}});
  root["bufferViews"].push_back(
      {{"buffer", root["buffers"].size() - 1}, {"byteOffset", 0}, {"byteLength", bytes.size()}});
  return static_cast<int>(root["bufferViews"].size()) - 1;
}

int addAccessor(json& root, const std::vector<std::uint8_t>& bytes, int component_type, int count,
                const std::string& type, bool normalised) {
  json accessor = {{"bufferView", addView(root, bytes)},
                   {"componentType", component_type},
                   {"count", count},
                   {"type", type}};
  if (normalised) {
    accessor["normalized"] = true;
  }
  root["accessors"].push_back(accessor);
  return static_cast<int>(root["accessors"].size()) - 1;
}

void setPositions(json& root, const std::vector<float>& positions) {
  json& primitive = primitiveOf(root);
  primitive.erase("indices");
  primitive["attributes"]["POSITION"] =
      addAccessor(root, bytesOf(positions), kFloat, static_cast<int>(positions.size() / 3), "VEC3");
}

void animate(json& root, int node, const std::string& path, const std::string& interpolation,
             const std::vector<float>& times, const std::vector<float>& values) {
  const bool is_rotation = path == "rotation";
  const std::size_t components = is_rotation ? 4 : 3;
  const int input = addAccessor(root, bytesOf(times), kFloat, static_cast<int>(times.size()), "SCALAR");
  const int output = addAccessor(root, bytesOf(values), kFloat, static_cast<int>(values.size() / components),
                                 is_rotation ? "VEC4" : "VEC3");
  root["animations"].push_back(
      {{"samplers", {{{"input", input}, {"output", output}, {"interpolation", interpolation}}}},
       {"channels", {{{"sampler", 0}, {"target", {{"node", node}, {"path", path}}}}}}});
}

Expected<Scene> loadFile(const json& root, const SceneOptions& options) {
  const ScratchFolder folder;
  return loadScene(folder.write("a.gltf", root.dump()), options);
}

std::string refusalOf(const json& root, const SceneOptions& options) {
  const Expected<Scene> scene = loadFile(root, options);
  return scene ? "" : sentence(scene.error());
}

namespace {

void append32(std::vector<std::uint8_t>& bytes, std::uint32_t value) {
  for (unsigned shift = 32; shift > 0; shift -= 8) {
    bytes.push_back(static_cast<std::uint8_t>(value >> (shift - 8)));
  }
}

std::uint32_t crc32(const std::vector<std::uint8_t>& bytes, std::size_t first) {
  std::uint32_t crc = 0xFFFFFFFFU;
  for (std::size_t i = first; i < bytes.size(); ++i) {
    crc ^= bytes[i];
    for (int bit = 0; bit < 8; ++bit) {
      crc = crc >> 1U ^ (0xEDB88320U & (0U - (crc & 1U)));
    }
  }
  return ~crc;
}

void appendChunk(std::vector<std::uint8_t>& png, std::string_view kind,
                 const std::vector<std::uint8_t>& content) {
  append32(png, static_cast<std::uint32_t>(content.size()));
  const std::size_t first = png.size();
  png.insert(png.end(), kind.begin(), kind.end());
  png.insert(png.end(), content.begin(), content.end());
  append32(png, crc32(png, first));
}

}  // namespace

std::vector<std::uint8_t> plainPng(int width, int height, std::uint8_t red, std::uint8_t green,
                                   std::uint8_t blue) {
  std::vector<std::uint8_t> rows;
  for (int y = 0; y < height; ++y) {
    rows.push_back(0);
    for (int x = 0; x < width; ++x) {
      rows.insert(rows.end(), {red, green, blue});
    }
  }
  std::uint32_t a = 1;
  std::uint32_t b = 0;
  for (const std::uint8_t value : rows) {
    a = (a + value) % 65521;
    b = (b + a) % 65521;
  }
  const auto size = static_cast<std::uint16_t>(rows.size());
  std::vector<std::uint8_t> stream{0x78,
                                   0x01,
                                   0x01,
                                   static_cast<std::uint8_t>(size & 0xFFU),
                                   static_cast<std::uint8_t>(size >> 8U),
                                   static_cast<std::uint8_t>(~size & 0xFFU),
                                   static_cast<std::uint8_t>(~size >> 8U & 0xFFU)};
  stream.insert(stream.end(), rows.begin(), rows.end());
  append32(stream, b << 16U | a);
  std::vector<std::uint8_t> header;
  append32(header, static_cast<std::uint32_t>(width));
  append32(header, static_cast<std::uint32_t>(height));
  header.insert(header.end(), {8, 2, 0, 0, 0});
  std::vector<std::uint8_t> png{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  appendChunk(png, "IHDR", header);
  appendChunk(png, "IDAT", stream);
  appendChunk(png, "IEND", {});
  return png;
}

bool hasNote(const Scene& scene, const std::string& text) {
  return std::any_of(scene.notes.begin(), scene.notes.end(),
                     [&](const std::string& note) { return note.find(text) != std::string::npos; });
}

}  // namespace ssrkit::test
