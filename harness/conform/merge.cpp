#include "conform/merge.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/text.h"
#include "conform/cell_store.h"
#include "conform/extra_tests.h"

namespace ssrkit {

namespace {

const std::string kAttempted = "merge the folders of shards";

struct Part {
  std::filesystem::path folder;
  Manifest manifest;
};

Expected<std::vector<Part>> readParts(std::span<const std::filesystem::path> folders) {
  std::vector<Part> parts;
  for (const std::filesystem::path& folder : folders) {
    auto manifest = CellStore(folder).manifest();
    if (!manifest) {
      return tl::make_unexpected(manifest.error());
    }
    parts.push_back({folder, std::move(*manifest)});
  }
  return parts;
}

// All of one plan, each shard once.
Expected<void> requireOnePlan(const std::vector<Part>& parts) {
  const Part& first = parts.front();
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const Manifest& manifest = parts[i].manifest;
    if (manifest.cells != first.manifest.cells || manifest.shard.count != first.manifest.shard.count ||
        manifest.kit_version != first.manifest.kit_version) {
      return inputError(kAttempted, fmt::format("it belongs to another run than {}", first.folder.string()),
                        parts[i].folder.string(),
                        "merge the shards of one command, of one version of the kit");
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (parts[j].manifest.shard == manifest.shard) {
        return inputError(kAttempted,
                          fmt::format("shard {} comes twice: in {} and in {}", shardText(manifest.shard),
                                      parts[j].folder.string(), parts[i].folder.string()),
                          "", "name one of the two");
      }
    }
  }
  return {};
}

void noteMissing(const std::vector<Part>& parts, const Merged& merged, std::vector<std::string>& notes) {
  const int shard_count = parts.front().manifest.shard.count;
  for (int index = 1; index <= shard_count; ++index) {
    const auto part = std::ranges::find_if(
        parts, [&](const Part& candidate) { return candidate.manifest.shard.index == index; });
    std::size_t planned = 0;
    std::size_t missing = 0;
    for (std::size_t i = 0; i < merged.records.size(); ++i) {
      if (parts.front().manifest.shard_of_cell[i] == index) {
        ++planned;
        missing += outcomeOf(merged.records[i]) == Outcome::kMissing ? 1 : 0;
      }
    }
    if (part == parts.end()) {
      notes.push_back(fmt::format("shard {}/{} is missing, with {} cells", index, shard_count, planned));
    } else if (missing > 0) {
      notes.push_back(fmt::format("shard {}/{} in {} is not finished: {} of its {} cells are missing", index,
                                  shard_count, part->folder.string(), missing, planned));
    }
  }
}

void addDevices(const std::vector<Part>& parts, Manifest& manifest) {
  for (const Part& part : parts) {
    for (const DeviceRow& device : part.manifest.devices) {
      const auto same = [&](const DeviceRow& known) { return known.identity.id == device.identity.id; };
      if (std::ranges::none_of(manifest.devices, same)) {
        manifest.devices.push_back(device);
      }
    }
  }
  std::ranges::sort(manifest.devices, {}, [](const DeviceRow& device) { return device.identity.id; });
}

CellRecord recordOf(const std::string& id, int shard, const std::vector<Part>& parts) {
  for (const Part& part : parts) {
    if (part.manifest.shard.index != shard) {
      continue;
    }
    auto record = CellStore(part.folder).find(id);
    if (!record) {
      return missingCell(id, sentence(record.error()));
    }
    return *record ? std::move(**record)
                   : missingCell(id, fmt::format("{} did not finish it", part.folder.string()));
  }
  return missingCell(id, "its shard is missing");
}

}  // namespace

CellRecord missingCell(const std::string& id, const std::string& reason) {
  const std::vector<std::string> parts = split(id, '/');
  CellRecord record{.id = id};
  CheckResult check{
      .id = parts.front() + ".runs", .outcome = Outcome::kMissing, .metric = "runs", .message = reason};
  if (parts.size() == 4) {
    check.scene = parts[1];
    check.device = parts[3];
    const std::vector<std::string> sides = split(parts[2], 'x');
    check.size = {static_cast<int>(parseNumber(sides.front()).value_or(0)),
                  static_cast<int>(parseNumber(sides.back()).value_or(0))};
  }
  check.repro = conformCommandFor({id});
  record.checks.push_back(std::move(check));
  return record;
}

Expected<Merged> merge(std::span<const std::filesystem::path> folders) {
  if (folders.empty()) {
    return inputError(kAttempted, "no folder is named", "", "name the folder of each shard");
  }
  auto parts = readParts(folders);
  if (!parts) {
    return tl::make_unexpected(parts.error());
  }
  if (const auto one_plan = requireOnePlan(*parts); !one_plan) {
    return tl::make_unexpected(one_plan.error());
  }
  Merged merged{.manifest = parts->front().manifest, .records = {}, .notes = {}};
  const Manifest& plan = parts->front().manifest;
  std::size_t finding_maps = 0;
  for (std::size_t i = 0; i < plan.cells.size(); ++i) {
    merged.records.push_back(recordOf(plan.cells[i], plan.shard_of_cell[i], *parts));
    dropMaps(merged.records.back(), finding_maps);
  }
  noteMissing(*parts, merged, merged.notes);
  addDevices(*parts, merged.manifest);
  merged.manifest.shard = {};
  merged.manifest.shard_of_cell.assign(plan.cells.size(), 1);
  return merged;
}

Expected<std::vector<std::string>> failedCells(const std::filesystem::path& folder) {
  const CellStore store(folder);
  const auto manifest = store.manifest();
  if (!manifest) {
    return tl::make_unexpected(manifest.error());
  }
  std::vector<std::string> failed;
  for (const std::string& id : ownCells(*manifest)) {
    const auto record = store.find(id);
    if (!record || !*record || isFailure(outcomeOf(**record))) {
      failed.push_back(id);
    }
  }
  return failed;
}

}  // namespace ssrkit
