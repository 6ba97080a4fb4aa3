// The native peers of a run (native/trace.h) as cells beside the devices': what the CPU's own vectors make of
// the same rays, timed in the same rounds. Their answers are there to hold others against, and judged by
// nobody.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "command/suite.h"

namespace ssrkit {

// The names of those that this CPU runs, widest first.
[[nodiscard]] std::vector<std::string> nativePeersHere();

// `names` are devices and native peers mixed: those of one kind, in order.
[[nodiscard]] std::vector<std::string> devicesAmong(std::span<const std::string> names);
[[nodiscard]] std::vector<std::string> nativePeersAmong(std::span<const std::string> names);

// Adds a cell for each peer to the run: what the device's cell `over` traced by `hiz`, over its G-buffer,
// once for the record and `rounds` times for the clock. None where it traced nothing so.
void addNativeCells(std::span<const std::string> peers, const CellRun& over, int rounds, SceneRun& run);

// Adds further rounds to a peer's cell.
void timeNativeAgain(CellRun& cell, int rounds);

}  // namespace ssrkit
