// The file that is being loaded, for messages, and how large it may be.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "base/error.h"

namespace ssrkit {

// Of a model, and of each file that it names.
inline constexpr std::size_t kMaxGltfFileBytes = std::size_t{1} << 30;

struct GltfSource {
  std::filesystem::path file;

  // "FILE: PLACE: could not load the scene: PROBLEM; REMEDY". `place` is a path in the JSON
  // ("meshes[0].primitives[1]") or empty.
  [[nodiscard]] tl::unexpected<Error> refuse(const std::string& place, std::string problem,
                                             std::string remedy = {}) const {
    return inputError("load the scene", std::move(problem),
                      place.empty() ? file.string() : file.string() + ": " + place, std::move(remedy));
  }
};

}  // namespace ssrkit
