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

Expected<TraceParameters> parametersOf(const nlohmann::json& json, const std::string& file) {
  TraceParameters parameters;
  for (const auto& [name, value] : json.items()) {
    const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
    if (const auto set = setParameter(parameters, name, text, file); !set) {
      return tl::make_unexpected(set.error());
    }
  }
  return parameters;
}

Expected<BenchSeries> seriesOf(const nlohmann::json& json, const std::string& file) {
  BenchSeries series;
  series.scene = json.at("scene").get<std::string>();
  series.device = json.at("device").get<std::string>();
  series.stage = json.at("stage").get<std::string>();
  series.case_name = json.at("case").get<std::string>();
  series.size = {json.at("size").at(0).get<int>(), json.at("size").at(1).get<int>()};
  series.pass = json.at("pass").get<std::string>();
  if (const nlohmann::json& parameters = json.at("parameters"); !parameters.is_null()) {
    const auto read = parametersOf(parameters, file);
    if (!read) {
      return tl::make_unexpected(read.error());
    }
    series.parameters = *read;
  }
  for (const nlohmann::json& time : json.at("steady")) {
    series.steady.push_back(timeOf(time));
  }
  return series;
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
  const nlohmann::json version = json.value("schema_version", nlohmann::json());
  if (version != kBenchSchemaVersion) {
    return inputError(
        attempted,
        fmt::format("its schema_version is {} and not {}{}", version.dump(), kBenchSchemaVersion,
                    version == 1 ? ": it does not say which parameters its traces were timed with" : ""),
        file.string(), "measure it again with this version");
  }
  BenchBaseline baseline{.file = file.string()};
  try {
    baseline.machine = {json.at("machine").at("cpu").get<std::string>(),
                        json.at("machine").at("core_count").get<int>()};
    for (const nlohmann::json& series : json.at("series")) {
      auto read = seriesOf(series, file.string());
      if (!read) {
        return tl::make_unexpected(read.error());
      }
      baseline.series.push_back(std::move(*read));
    }
    baseline.replacements = json.at("replacements").get<std::vector<std::string>>();
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

Expected<BenchComparison> compareWith(const BenchBaseline& baseline, const std::vector<BenchSeries>& series) {
  BenchComparison comparison = compareSeries(series, baseline.series);
  if (comparison.changes.empty()) {
    return inputError(
        "compare with the baseline",
        comparison.uncompared.empty()
            ? "it has no passes"
            : fmt::format("no pass can be compared: the first, {} of {}, is {}",
                          comparison.uncompared.front().series.pass,
                          comparison.uncompared.front().series.scene, comparison.uncompared.front().why),
        baseline.file, "use the scenes, sizes, stages, devices and parameters that it was measured with");
  }
  return comparison;
}

}  // namespace ssrkit
