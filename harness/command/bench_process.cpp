#include <fmt/format.h>

#include <algorithm>

#include "base/atomic_file.h"
#include "check/field_reader.h"
#include "check/paired_ratio.h"
#include "check/read_expectations.h"
#include "check/toml_document.h"
#include "command/bench_work.h"
#include "command/empty_folder.h"
#include "command/process_cost.h"

namespace ssrkit {

namespace {

// What one whole run may cost.
struct ProcessGate {
  std::string id;
  std::vector<std::string> arguments;
  int runs = 1;
  std::optional<double> max_wall_s;
  std::optional<double> max_memory_mib;
};

Expected<ProcessGate> readGate(const std::filesystem::path& path) {
  constexpr double kDay_s = 86400.0;
  constexpr double kMuchMemory = 1e6;
  const std::string attempted = fmt::format("read the gate '{}'", path.string());
  const Expected<std::string> content = readFile(path);
  const auto document =
      content ? parseToml(*content, path.string(), attempted) : tl::make_unexpected(content.error());
  if (!document) {
    return tl::make_unexpected(document.error());
  }
  const TomlEntry* const section = document->find("process");
  if (section == nullptr || section->value.kind != TomlValue::Kind::kTable || document->entries.size() != 1) {
    return inputError(attempted, "it is not one [process] section", placeText(path.string(), {1, 1}),
                      "write [process] with id, about, arguments and max_wall_s or max_memory_mib");
  }
  FieldReader fields(section->value, "[process]", path.string(), attempted);
  static const std::vector<std::string> kKeys = {"id",   "about",      "arguments",
                                                 "runs", "max_wall_s", "max_memory_mib"};
  fields.allowOnly(kKeys);
  ProcessGate gate;
  gate.id = fields.text("id");
  fields.requirePlainId("id", gate.id);
  static_cast<void>(fields.text("about"));
  gate.arguments = fields.texts("arguments");
  gate.runs = fields.integer("runs", 1, 1000).value_or(gate.runs);
  gate.max_wall_s = fields.number("max_wall_s", 0.0, kDay_s);
  gate.max_memory_mib = fields.number("max_memory_mib", 0.0, kMuchMemory);
  if (!gate.max_wall_s && !gate.max_memory_mib) {
    fields.complain("arguments", "it bounds nothing", "add max_wall_s = ... or max_memory_mib = ...");
  }
  return fields.ok() ? Expected<ProcessGate>(std::move(gate)) : tl::make_unexpected(fields.result().error());
}

CheckResult wallCheck(const ProcessGate& gate, const std::vector<double>& wall_s) {
  CheckResult check{
      .id = gate.id, .outcome = Outcome::kInconclusive, .metric = "wall", .max = gate.max_wall_s};
  check.unit = "s";
  check.compared = wall_s.size();
  if (const auto median = medianInterval(wall_s)) {
    check.value = median->median;
    check.interval = {median->low, median->high};
    check.outcome = judgeRatio(*median, std::nullopt, gate.max_wall_s, 0.0);
  }
  return check;
}

CheckResult memoryCheck(const ProcessGate& gate, double peak_mib) {
  CheckResult check{.id = gate.id, .metric = "memory", .value = peak_mib, .max = gate.max_memory_mib};
  check.unit = "MiB";
  check.compared = 1;
  check.outcome = peak_mib <= *gate.max_memory_mib ? Outcome::kPass : Outcome::kFail;
  return check;
}

Expected<void> measureGate(const ProcessGate& gate, const BenchWork& work, std::vector<CheckResult>& checks) {
  const auto out = EmptyFolder::create();
  if (!out) {
    return tl::make_unexpected(out.error());
  }
  std::vector<std::string> arguments = gate.arguments;
  arguments.insert(arguments.end(), {"--out", out->path()});
  std::vector<double> wall_s;
  double peak_mib = 0.0;
  for (int run = gate.max_wall_s ? -1 : 0; run < gate.runs;
       ++run) {  // the one before the first fills the caches
    work.progress.show(fmt::format("{}: run {} of {}", gate.id, run + 1, gate.runs));
    const auto cost = measureProcess(arguments, gate.max_memory_mib.has_value());
    if (!cost) {
      return tl::make_unexpected(cost.error());
    }
    if (cost->exit_code != 0) {
      CheckResult failed{.id = gate.id, .outcome = Outcome::kError, .metric = "runs"};
      failed.message = fmt::format("error: {}: ./ssrkit {} ended with code {}", gate.id,
                                   fmt::join(gate.arguments, " "), cost->exit_code);
      checks.push_back(std::move(failed));
      return {};
    }
    peak_mib = std::max(peak_mib, cost->peak_memory_mib);
    if (run >= 0) {
      wall_s.push_back(cost->wall_s);
    }
  }
  if (gate.max_wall_s) {
    checks.push_back(wallCheck(gate, wall_s));
  }
  if (gate.max_memory_mib) {
    checks.push_back(memoryCheck(gate, peak_mib));
  }
  for (CheckResult& check : checks) {
    check.message = check.message.empty() ? fullName(check) : check.message;
  }
  return {};
}

}  // namespace

Expected<std::vector<CheckResult>> measureProcessGates(const BenchWork& work) {
  std::vector<CheckResult> checks;
  std::error_code unreadable;
  const std::filesystem::path folder = work.paths.gates / "process";
  if (!std::filesystem::exists(folder, unreadable)) {
    return checks;
  }
  const auto files = tomlFiles(folder, "read the gates of whole runs");
  if (!files) {
    return tl::make_unexpected(files.error());
  }
  std::vector<ProcessGate> gates;
  for (const std::filesystem::path& file : *files) {
    auto gate = readGate(file);
    if (!gate) {
      return tl::make_unexpected(gate.error());
    }
    gates.push_back(std::move(*gate));
  }
  for (const ProcessGate& gate : gates) {
    if (const auto measured = measureGate(gate, work, checks); !measured) {
      return tl::make_unexpected(measured.error());
    }
  }
  return checks;
}

}  // namespace ssrkit
