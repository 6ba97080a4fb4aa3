// What a scene was traced with, beside its camera.json: with it a G-buffer that `run` wrote is traced again
// as it was.
#pragma once

#include <filesystem>

#include "base/error.h"
#include "spaces/trace_parameters.h"

namespace ssrkit {

// FOLDER/parameters.toml, in the form of the TOML file beside a scene.
[[nodiscard]] Expected<void> writeParametersFile(const std::filesystem::path& folder,
                                                 const TraceParameters& parameters);

// The one beside the camera.json that readGbuffer takes for the folder; others' G-buffers need not have it.
[[nodiscard]] Expected<TraceParameters> parametersBesideCamera(const std::filesystem::path& gbuffer);

}  // namespace ssrkit
