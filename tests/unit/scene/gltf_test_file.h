// Small glTF files for the tests: a valid one to start from, and a folder to put it in.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scene/load.h"

namespace ssrkit::test {

// A folder that goes away with the object.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  // Returns the path of the file `name` with this content.
  std::filesystem::path write(const std::string& name, const std::string& content) const;

 private:
  std::filesystem::path path_;
};

[[nodiscard]] std::string dataUri(const std::vector<std::uint8_t>& bytes);

template <class T>
std::vector<std::uint8_t> bytesOf(const std::vector<T>& values) {
  const auto* first = reinterpret_cast<const std::uint8_t*>(values.data());
  return {first, first + values.size() * sizeof(T)};
}

// One triangle, (0,0,0) (1,0,0) (0,1,0), as float positions and 16-bit indices in one data: buffer. No
// material, camera or light. accessors[0] are the positions and accessors[1] the indices.
[[nodiscard]] nlohmann::json triangleFile();

// Its primitive: the first mesh's first.
[[nodiscard]] nlohmann::json& primitiveOf(nlohmann::json& root);

// Adds a buffer and a view of all of it; returns the view's index.
int addView(nlohmann::json& root, const std::vector<std::uint8_t>& bytes);

// Adds an accessor over a view of its own; returns its index.
int addAccessor(nlohmann::json& root, const std::vector<std::uint8_t>& bytes, int component_type, int count,
                const std::string& type, bool normalised = false);

// Gives the first primitive vertices of its own: as many positions as there are, and no indices.
void setPositions(nlohmann::json& root, const std::vector<float>& positions);

// Animates a property of a node in an animation of its own, as floats; `path` is "translation", "rotation",
// ...
void animate(nlohmann::json& root, int node, const std::string& path, const std::string& interpolation,
             const std::vector<float>& times, const std::vector<float>& values);

// Writes and loads the document.
[[nodiscard]] Expected<Scene> loadFile(const nlohmann::json& root, const SceneOptions& options = {});

// The error's sentence, "" when it loads.
[[nodiscard]] std::string refusalOf(const nlohmann::json& root, const SceneOptions& options = {});

// A PNG of one colour, 8-bit RGB, `width` x `height`, without compression.
[[nodiscard]] std::vector<std::uint8_t> plainPng(int width, int height, std::uint8_t red, std::uint8_t green,
                                                 std::uint8_t blue);

// Whether a note of the scene holds `text`.
[[nodiscard]] bool hasNote(const Scene& scene, const std::string& text);

inline constexpr int kByte = 5120;
inline constexpr int kUnsignedByte = 5121;
inline constexpr int kShort = 5122;
inline constexpr int kUnsignedShort = 5123;
inline constexpr int kUnsignedInt = 5125;
inline constexpr int kFloat = 5126;

}  // namespace ssrkit::test
