#include "command/conform.h"
#include "command/conform_report.h"
#include "command/kit_paths.h"
#include "command/output_folder.h"
#include "conform/cell_store.h"
#include "conform/merge.h"

namespace ssrkit {

Expected<int> conformMergeCommand(const ConformMergeOptions& options) {
  const std::vector<std::filesystem::path> folders(options.folders.begin(), options.folders.end());
  auto merged = merge(folders);
  auto known = readKnownFailures(options.baseline, kitPaths());
  Expected<void> done = !merged  ? tl::make_unexpected(merged.error())
                        : !known ? tl::make_unexpected(known.error())
                                 : prepareFolder(options.out);
  if (!done) {
    return tl::make_unexpected(done.error());
  }
  const CellStore store(options.out);
  done = store.write(merged->manifest);
  for (const CellRecord& record : merged->records) {
    const bool is_missing = outcomeOf(record) == Outcome::kMissing;
    // The merged folder is one that a whole run would have left: what is missing there is missing here.
    done = done ? (is_missing ? store.remove(record.id) : store.write(record)) : done;
  }
  if (!done) {
    return tl::make_unexpected(done.error());
  }
  return finishConform({.manifest = std::move(merged->manifest),
                        .records = std::move(merged->records),
                        .notes = std::move(merged->notes),
                        .known_failures = std::move(*known),
                        .command = options.command,
                        .out = options.out,
                        .json = options.json});
}

}  // namespace ssrkit
