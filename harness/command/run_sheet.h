// The contact sheet of one cell of a run.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"
#include "command/cell_run.h"
#include "report/run_report.h"

namespace ssrkit {

// Of a cell with a result. `rows` are the run's rows of this scene: they know what the traces cost. May be
// called from several threads at once.
[[nodiscard]] Expected<void> writeSheet(const std::filesystem::path& file, const CellRun& cell,
                                        const std::string& scene, const std::vector<RunRow>& rows);

}  // namespace ssrkit
