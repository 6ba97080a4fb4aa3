// The file that is being loaded, for messages.
#pragma once

#include <filesystem>
#include <string>

#include "base/error.h"

namespace ssrkit {

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
