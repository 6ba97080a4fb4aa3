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
  std::optional<double> min_speedup_on_2_cores;  // of wall time, over the same run on one

  // Clocks want full caches, and are read in rounds.
  [[nodiscard]] bool isTimed() const { return max_wall_s || min_speedup_on_2_cores; }
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
                      "write [process] with id, about, arguments and a bound");
  }
  FieldReader fields(section->value, "[process]", path.string(), attempted);
  static const std::vector<std::string> kKeys = {
      "id", "about", "arguments", "runs", "max_wall_s", "max_memory_mib", "min_speedup_on_2_cores"};
  fields.allowOnly(kKeys);
  ProcessGate gate;
  gate.id = fields.text("id");
  fields.requirePlainId("id", gate.id);
  static_cast<void>(fields.text("about"));
  gate.arguments = fields.texts("arguments");
  gate.runs = fields.integer("runs", 1, 1000).value_or(gate.runs);
  gate.max_wall_s = fields.number("max_wall_s", 0.0, kDay_s);
  gate.max_memory_mib = fields.number("max_memory_mib", 0.0, kMuchMemory);
  gate.min_speedup_on_2_cores = fields.number("min_speedup_on_2_cores", 0.0, 2.0);
  if (!gate.isTimed() && !gate.max_memory_mib) {
    fields.complain("arguments", "it bounds nothing",
                    "add max_wall_s = ..., max_memory_mib = ... or min_speedup_on_2_cores = ...");
  }
  return fields.ok() ? Expected<ProcessGate>(std::move(gate)) : tl::make_unexpected(fields.result().error());
}

// What its runs cost, in the order in which they were made.
struct GateRuns {
  std::vector<double> wall_s;
  std::vector<double> one_core_wall_s;  // with a speed-up to measure: each right after the one on two cores
  double peak_mib = 0.0;
  int exit_code = 0;  // of the last; no run follows one that ended with another than 0
};

CheckResult judged(const ProcessGate& gate, const char* metric, const char* unit,
                   const std::optional<RatioInterval>& median, std::optional<double> min,
                   std::optional<double> max) {
  CheckResult check{
      .id = gate.id, .outcome = Outcome::kInconclusive, .metric = metric, .max = max, .min = min};
  check.unit = unit;
  check.compared = static_cast<std::size_t>(gate.runs);
  if (median) {
    check.value = median->median;
    check.interval = {median->low, median->high};
    check.outcome = judgeRatio(*median, min, max, 0.0);
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

Expected<GateRuns> runAll(const ProcessGate& gate, const BenchWork& work) {
  const auto out = EmptyFolder::create();
  if (!out) {
    return tl::make_unexpected(out.error());
  }
  std::vector<std::string> arguments = gate.arguments;
  arguments.insert(arguments.end(), {"--out", out->path()});
  const std::vector<int> core_counts = gate.min_speedup_on_2_cores ? std::vector{2, 1} : std::vector{0};
  GateRuns runs;
  for (int run = gate.isTimed() ? -1 : 0; run < gate.runs;
       ++run) {  // the one before the first fills the caches
    work.progress.show(fmt::format("{}: run {} of {}", gate.id, run + 1, gate.runs));
    for (const int core_count : core_counts) {
      const auto cost = measureProcess(arguments, gate.max_memory_mib.has_value(), core_count);
      if (!cost) {
        return tl::make_unexpected(cost.error());
      }
      runs.exit_code = cost->exit_code;
      if (runs.exit_code != 0) {
        return runs;
      }
      runs.peak_mib = std::max(runs.peak_mib, cost->peak_memory_mib);
      if (run >= 0) {
        (core_count == 1 ? runs.one_core_wall_s : runs.wall_s).push_back(cost->wall_s);
      }
    }
  }
  return runs;
}

CheckResult withMessage(CheckResult check, const std::string& what = {}) {
  check.message =
      what.empty() ? fullName(check) : fmt::format("{}: {}: {}", name(check.outcome), check.id, what);
  return check;
}

Expected<void> measureGate(const ProcessGate& gate, const BenchWork& work, std::vector<CheckResult>& checks) {
  if (gate.min_speedup_on_2_cores && usableCoreCount() < 2) {
    checks.push_back(withMessage({.id = gate.id, .outcome = Outcome::kSkip, .metric = "speedup_on_2_cores"},
                                 "there is one core only"));
    return {};
  }
  const auto runs = runAll(gate, work);
  if (!runs) {
    return tl::make_unexpected(runs.error());
  }
  if (runs->exit_code != 0) {
    checks.push_back(withMessage(
        {.id = gate.id, .outcome = Outcome::kError, .metric = "runs"},
        fmt::format("./ssrkit {} ended with code {}", fmt::join(gate.arguments, " "), runs->exit_code)));
    return {};
  }
  if (gate.max_wall_s) {
    checks.push_back(
        withMessage(judged(gate, "wall", "s", medianInterval(runs->wall_s), std::nullopt, gate.max_wall_s)));
  }
  if (gate.min_speedup_on_2_cores) {
    checks.push_back(withMessage(judged(gate, "speedup_on_2_cores", "times faster than on 1",
                                        pairedRatio(runs->one_core_wall_s, runs->wall_s),
                                        gate.min_speedup_on_2_cores, std::nullopt)));
  }
  if (gate.max_memory_mib) {
    checks.push_back(withMessage(memoryCheck(gate, runs->peak_mib)));
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
