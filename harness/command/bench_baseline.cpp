#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "command/bench_work.h"

namespace ssrkit {

namespace {

PassTime timeOf(const nlohmann::json& json) {
  return {.wall_ns = json.at("wall_ns").get<std::int64_t>(), .cpu_ns = json.at("cpu_ns").get<std::int64_t>()};
}

BenchSeries seriesOf(const nlohmann::json& json) {
  BenchSeries series;
  series.scene = json.at("scene").get<std::string>();
  series.device = json.at("device").get<std::string>();
  series.stage = json.at("stage").get<std::string>();
  series.case_name = json.at("case").get<std::string>();
  series.size = {json.at("size").at(0).get<int>(), json.at("size").at(1).get<int>()};
  series.pass = json.at("pass").get<std::string>();
  for (const nlohmann::json& time : json.at("steady")) {
    series.steady.push_back(timeOf(time));
  }
  return series;
}

bool isSame(const BenchSeries& a, const BenchSeries& b) {
  return a.scene == b.scene && a.device == b.device && a.stage == b.stage && a.case_name == b.case_name &&
         a.size == b.size && a.pass == b.pass;
}

std::vector<double> cpuOf(const BenchSeries& series) {
  std::vector<double> values;
  for (const PassTime& time : series.steady) {
    values.push_back(static_cast<double>(time.cpu_ns));
  }
  return values;
}

}  // namespace

Expected<BenchBaseline> readBaseline(const std::filesystem::path& file) {
  const std::string attempted = fmt::format("read the baseline '{}'", file.string());
  const Expected<std::string> content = readFile(file);
  if (!content) {
    return tl::make_unexpected(content.error());
  }
  constexpr const char* kRemedy = "give the bench.json that an earlier ./ssrkit bench wrote";
  const nlohmann::json json = nlohmann::json::parse(*content, nullptr, false);
  if (!json.is_object() || json.value("schema", nlohmann::json()) != "ssrkit-bench") {
    return inputError(attempted, "it is no bench.json", file.string(), kRemedy);
  }
  if (json.value("schema_version", nlohmann::json()) != kBenchSchemaVersion) {
    return inputError(attempted, fmt::format("its schema_version is not {}", kBenchSchemaVersion),
                      file.string(), "measure it again with this version");
  }
  BenchBaseline baseline{.file = file.string()};
  try {
    baseline.machine = {json.at("machine").at("cpu").get<std::string>(),
                        json.at("machine").at("core_count").get<int>()};
    for (const nlohmann::json& series : json.at("series")) {
      baseline.series.push_back(seriesOf(series));
    }
  } catch (const nlohmann::json::exception& problem) {
    return inputError(attempted,
                      fmt::format("a part of it is missing or of another kind ({})", problem.what()),
                      file.string(), kRemedy);
  }
  return baseline;
}

Expected<void> checkSameMachine(const BenchBaseline& baseline, const BenchMachine& machine) {
  if (baseline.machine.cpu == machine.cpu && baseline.machine.core_count == machine.core_count) {
    return {};
  }
  return inputError(
      "compare with the baseline",
      fmt::format("it was measured on '{}' with {} cores, this machine is '{}' with {}", baseline.machine.cpu,
                  baseline.machine.core_count, machine.cpu, machine.core_count),
      baseline.file, "measure a baseline on this machine");
}

Expected<std::vector<BenchChange>> changesSince(const BenchBaseline& baseline,
                                                const std::vector<BenchSeries>& series) {
  std::vector<BenchChange> changes;
  for (const BenchSeries& now : series) {
    const auto then =
        std::ranges::find_if(baseline.series, [&](const BenchSeries& other) { return isSame(now, other); });
    if (then == baseline.series.end()) {
      continue;
    }
    const auto ratio = unpairedRatio(cpuOf(now), cpuOf(*then));
    changes.push_back({.series = &now, .ratio = ratio, .move = moveOf(ratio, kBenchMargin)});
  }
  if (changes.empty()) {
    return inputError("compare with the baseline", "it has none of the passes that were timed", baseline.file,
                      "use the scenes, sizes, stages and devices that it was measured with");
  }
  return changes;
}

}  // namespace ssrkit
