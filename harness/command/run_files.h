// What `run` writes for each scene (docs/formats.md).
#pragma once

#include <filesystem>

#include "base/error.h"
#include "command/suite.h"
#include "report/run_report.h"

namespace ssrkit {

// Writes DIR/SCENE/...; `rows` are the run's rows of this scene, for the contact sheets. The run's images and
// records are given up one by one, as they are written.
[[nodiscard]] Expected<void> writeSceneFiles(const std::filesystem::path& folder, SceneRun run,
                                             const std::vector<RunRow>& rows);

}  // namespace ssrkit
