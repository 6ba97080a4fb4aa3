// Pictures of what failed in a cell.
#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "check/expectation.h"
#include "command/suite.h"
#include "conform/cell.h"
#include "conform/cell_store.h"

namespace ssrkit {

// For each failed check of the cell: of rays the map of verdicts against the oracle (colours of the contact
// sheets) in white the rays that hold against it and differ from the truth's, of an image the size of the
// difference per pixel, on a logarithmic scale from 1e-8 (dark) to 1 (yellow), relative to the truth. Nothing
// where nothing failed or nothing can be shown. Beside the cell's record, one file a stage, case and buffer.
[[nodiscard]] Expected<void> writeFailurePictures(const TestFile& test, const Cell& cell, const SceneRun& run,
                                                  const CellStore& store);

}  // namespace ssrkit
