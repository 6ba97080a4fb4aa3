// What lights a scene from outside, as its TOML file or the command line says: a constant, a picture, or,
// unsaid, the gradient between the sky's two colours.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "base/error.h"

namespace ssrkit {

struct EnvironmentChoice {
  std::filesystem::path file;  // an equirectangular EXR; empty: none
  std::optional<glm::vec3> constant;

  friend bool operator==(const EnvironmentChoice&, const EnvironmentChoice&) = default;
};

// "constant:R,G,B", linear, each 0 to 1000, or a file's name, taken from `folder` when it is not absolute.
// `where` names the place for messages. The file itself is looked at when it is needed.
[[nodiscard]] Expected<EnvironmentChoice> parseEnvironment(const std::string& text,
                                                           const std::filesystem::path& folder,
                                                           const std::string& where);

}  // namespace ssrkit
