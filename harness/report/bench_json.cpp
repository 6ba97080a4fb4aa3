#include <nlohmann/json.hpp>

#include "base/json_text.h"
#include "report/bench_report.h"
#include "report/json_parts.h"

namespace ssrkit {

namespace {

Json intervalOf(const std::optional<RatioInterval>& interval) {
  return interval ? Json{{"median", interval->median}, {"low", interval->low}, {"high", interval->high}}
                  : Json(nullptr);
}

Json keyOf(const BenchSeries& series) {
  return {{"scene", series.scene}, {"device", series.device},  {"size", sizeOf(series.size)},
          {"stage", series.stage}, {"case", series.case_name}, {"pass", series.pass}};
}

Json seriesJson(const BenchSeries& series, const BenchReport& report) {
  Json json = keyOf(series);
  json["parameters"] = series.parameters ? parametersOf(*series.parameters) : Json(nullptr);
  json["rays"] = series.rays;
  json["lookups"] = series.lookups;
  json["cpu_ms"] = intervalOf(cpuMsInterval(series));
  json["roofline_multiple"] =
      series.pass == "trace" ? intervalOf(rooflineMultiple(series, report.series)) : Json(nullptr);
  const Json passes = passesOf({{.pass = series.pass, .cold = series.first, .steady = series.steady}});
  json["first"] = passes.front()["cold"];
  json["steady"] = passes.front()["steady"];
  return json;
}

Json overNativeOf(const BenchNativeRatio& over) {
  Json json = keyOf(*over.series);
  json["peer"] = over.peer;
  json["ratio"] = intervalOf(over.ratio);
  return json;
}

Json startOf(const BenchStart& start) {
  return {{"scene", start.scene},           {"device", start.device},
          {"has_caches", start.has_caches}, {"create_ns", start.create_ns},
          {"compile_ns", start.compile_ns}, {"pipeline_ns", start.pipeline_ns},
          {"first_ns", start.first_ns}};
}

Json answerOf(const BenchAnswer& answer) {
  Json verdicts = Json::object();
  for (int i = 0; i < kVerdictCount; ++i) {
    verdicts[name(static_cast<Verdict>(i))] = answer.verdicts.at(static_cast<std::size_t>(i));
  }
  return {{"scene", answer.scene},
          {"device", answer.device},
          {"size", sizeOf(answer.size)},
          {"stage", answer.stage},
          {"case", answer.case_name},
          {"rays", answer.rays},
          {"verdicts", std::move(verdicts)},
          {"mask_errors", answer.mask_errors},
          {"lookups",
           {{"mean", answer.lookups_per_ray}, {"p95", answer.p95_lookups}, {"max", answer.max_lookups}}}};
}

Json lawOf(const std::optional<PowerLaw>& law) {
  return law ? Json{{"exponent", law->exponent},
                    {"standard_error", law->standard_error},
                    {"factor", law->factor}}
             : Json(nullptr);
}

Json scalingOf(const BenchScaling& scaling) {
  Json points = Json::array();
  for (const BenchScalingPoint& point : scaling.points) {
    points.push_back({{"label", point.label},
                      {"x", point.x},
                      {"ns_per_ray", point.ns_per_ray},
                      {"lookups_per_ray", point.lookups_per_ray}});
  }
  return {{"axis", scaling.axis},        {"x_unit", scaling.x_unit},          {"clock", scaling.clock},
          {"scene", scaling.scene},      {"device", scaling.device},          {"stage", scaling.stage},
          {"time", lawOf(scaling.time)}, {"lookups", lawOf(scaling.lookups)}, {"points", std::move(points)}};
}

Json changeOf(const BenchChange& change) {
  Json json = keyOf(*change.series);
  json["ratio"] = intervalOf(change.ratio);
  json["move"] = name(change.move);
  return json;
}

Json uncomparedOf(const BenchUncompared& uncompared) {
  Json json = keyOf(uncompared.series);
  json["why"] = uncompared.why;
  return json;
}

Json gateOf(const CheckResult& gate) {
  return {{"id", gate.id},
          {"scene", gate.scene},
          {"device", gate.device},
          {"stage", gate.stage},
          {"size", sizeOf(gate.size)},
          {"case", gate.case_name},
          {"outcome", name(gate.outcome)},
          {"metric", gate.metric},
          {"value", numberOf(gate.value)},
          {"unit", gate.unit},
          {"bound", {{"min", numberOf(gate.min)}, {"max", numberOf(gate.max)}}},
          {"interval",
           gate.interval ? Json::array({gate.interval->first, gate.interval->second}) : Json(nullptr)},
          {"remark", gate.remark}};
}

}  // namespace

std::string benchJson(const BenchReport& report) {
  const Json json = {
      {"schema", "ssrkit-bench"},
      {"schema_version", kBenchSchemaVersion},
      {"kit_version", report.kit_version},
      {"started", report.started},
      {"command", report.command},
      {"machine", {{"cpu", report.machine.cpu}, {"core_count", report.machine.core_count}}},
      {"devices", listOf(report.devices, deviceOf)},
      {"starts", listOf(report.starts, startOf)},
      {"series", listOf(report.series, [&](const BenchSeries& one) { return seriesJson(one, report); })},
      {"over_natives", listOf(report.over_natives, overNativeOf)},
      {"answers", listOf(report.answers, answerOf)},
      {"scaling", listOf(report.scalings, scalingOf)},
      {"replacements", report.replacements},
      {"baseline", report.baseline.empty() ? Json(nullptr) : Json(report.baseline)},
      {"baseline_replacements", report.baseline_replacements},
      {"changes", listOf(report.comparison.changes, changeOf)},
      {"uncompared", listOf(report.comparison.uncompared, uncomparedOf)},
      {"gates", listOf(report.gates, gateOf)}};
  return jsonText(json, 1) + "\n";
}

}  // namespace ssrkit
