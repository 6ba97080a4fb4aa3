// NAME.toml beside a scene: what it shows and how it is best traced. The format is in docs/formats.md.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "base/error.h"
#include "scene/scene.h"
#include "spaces/trace_parameters.h"

namespace ssrkit {

struct SceneDefaults {
  std::string about;     // one sentence
  std::string pictured;  // what is in the picture
  std::string look_for;  // what to look for in it
  std::string camera;    // "" the file's first
  TraceParameters parameters;
  std::optional<glm::dvec3> light_direction_world;  // of the first directional light, unit
  std::optional<glm::vec3> light_radiance;
  std::optional<glm::vec3> sky_horizon;  // linear
  std::optional<glm::vec3> sky_zenith;
  std::optional<EnvironmentChoice> environment;
};

// Fails at file:line:column on bad TOML, unknown keys (with the nearest known one), wrong types and
// parameters out of their range.
[[nodiscard]] Expected<SceneDefaults> loadSceneDefaults(const std::filesystem::path& file);

// scenes/clutter/clutter.gltf -> scenes/clutter/clutter.toml; it need not exist.
[[nodiscard]] std::filesystem::path defaultsFileOf(const std::filesystem::path& scene_file);

// Puts the light and the sky into the scene.
void applyLook(const SceneDefaults& defaults, Scene& scene);

}  // namespace ssrkit
