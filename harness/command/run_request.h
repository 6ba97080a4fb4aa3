// What a `run` was asked for, from its options: scenes, stages, parameters, size, shaders.
#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "base/size.h"
#include "check/expectation.h"
#include "command/kit_paths.h"
#include "command/run.h"
#include "command/suite.h"

namespace ssrkit {

struct RunRequest {
  Size size;
  TestFile test;  // the built-in checks for any scene, with the chosen stages and parameters
  std::vector<SceneSource> scenes;   // the parameters in their defaults
  std::vector<std::string> devices;  // each once
  std::vector<ShaderReplacement> replacements;
  std::optional<EnvironmentChoice> environment;
};

// Fails on whatever is not there, misspelt or contradictory, before any work is done.
[[nodiscard]] Expected<RunRequest> readRequest(const RunOptions& options, const KitPaths& paths);

}  // namespace ssrkit
