#include "report/results_json.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "base/atomic_file.h"
#include "base/json_text.h"
#include "check/outcome.h"
#include "report/json_parts.h"
#include "report/ledger_json.h"

namespace ssrkit {

namespace {

Json checkOf(const CheckResult& check) {
  return {{"id", check.id},
          {"scene", check.scene},
          {"device", check.device},
          {"stage", check.stage},
          {"size", sizeOf(check.size)},
          {"case", check.case_name},
          {"parameters", check.parameters ? parametersOf(*check.parameters) : Json(nullptr)},
          {"outcome", name(check.outcome)},
          {"metric", check.metric},
          {"value", numberOf(check.value)},
          {"bound", {{"min", numberOf(check.min)}, {"max", numberOf(check.max)}}},
          {"unit", check.unit},
          {"message", check.message},
          {"repro", check.repro}};
}

Json classesOf(const TraceSummary& summary) {
  Json json = Json::object();
  for (std::size_t i = 0; i < summary.classes.size(); ++i) {
    json[name(static_cast<RayClass>(i))] = summary.classes[i];
  }
  return json;
}

Json verdictsOf(const VerdictCounts& verdicts) {
  Json json = Json::object();
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    json[name(static_cast<Verdict>(i))] = verdicts[i];
  }
  return json;
}

Json verdictsOf(const GeometryCounts& counts, std::size_t true_class) {
  Json json = Json::object();
  for (std::size_t i = 1; i < kGeometryVerdictCount; ++i) {
    json[name(static_cast<GeometryVerdict>(i))] = counts.verdicts.at(true_class).at(i);
  }
  return json;
}

Json trueClassesOf(const TrueClassSummary& summary) {
  Json json = Json::object();
  for (std::size_t i = 1; i < kTrueClassCount; ++i) {
    json[name(static_cast<TrueClass>(i))] = {{"rays", summary.geometry.rays.at(i)},
                                             {"oracle", verdictsOf(summary.against_oracle.at(i))},
                                             {"geometry", verdictsOf(summary.geometry, i)}};
  }
  return json;
}

Json geometryOf(const GeometryRow& row) {
  Json classes = Json::object();
  for (std::size_t i = 1; i < kTrueClassCount; ++i) {
    classes[name(static_cast<TrueClass>(i))] = {{"rays", row.counts.rays.at(i)},
                                                {"oracle", verdictsOf(row.counts, i)}};
  }
  return {{"scene", row.scene},
          {"device", row.device},
          {"size", sizeOf(row.size)},
          {"case", row.case_name},
          {"parameters", parametersOf(row.parameters)},
          {"rays", row.counts.rayCount()},
          {"true_classes", std::move(classes)}};
}

Json traceOf(const RunRow& row) {
  Json json = {{"scene", row.scene},
               {"device", row.device},
               {"stage", row.stage},
               {"size", sizeOf(row.size)},
               {"case", row.case_name},
               {"parameters", parametersOf(row.parameters)},
               {"outcome", name(row.outcome)},
               {"classes", nullptr},
               {"lookups", nullptr},
               {"verdicts", nullptr},
               {"true_classes", row.true_classes ? trueClassesOf(*row.true_classes) : Json(nullptr)},
               {"passes", passesOf(row.passes)}};
  if (row.summary) {
    const LookupSummary& lookups = row.summary->lookups;
    json["classes"] = classesOf(*row.summary);
    json["lookups"] = {{"mean", numberOf(lookups.mean)},
                       {"p50", numberOf(lookups.p50)},
                       {"p95", numberOf(lookups.p95)},
                       {"max", numberOf(lookups.max)}};
    json["verdicts"] = row.summary->verdicts ? verdictsOf(*row.summary->verdicts) : Json(nullptr);
  }
  return json;
}

Json summaryOf(const RunReport& report) {
  Json counts = Json::object();
  for (const CheckResult& check : report.checks) {
    Json& count = counts[name(check.outcome)];
    count = count.is_null() ? 1 : count.get<int>() + 1;
  }
  const std::vector<Outcome> outcomes = outcomesOf(report);
  return {
      {"outcomes", std::move(counts)}, {"line", closingLine(outcomes)}, {"exit_code", exitCode(outcomes)}};
}

Json unitTestsOf(const std::optional<UnitTestCounts>& counts) {
  return counts ? Json{{"passed", counts->passed}, {"failed", counts->failed}, {"skipped", counts->skipped}}
                : Json(nullptr);
}

}  // namespace

std::string resultsJson(const RunReport& report) {
  const auto frameOf = [](const FrameRow& row) -> Json {
    return {{"scene", row.scene},
            {"device", row.device},
            {"size", sizeOf(row.size)},
            {"passes", passesOf(row.passes)}};
  };
  const auto cellOf = [](const CellRow& row) -> Json {
    return {{"id", row.id},
            {"outcome", name(row.outcome)},
            {"checks", row.checks},
            {"time_s", row.time_s},
            {"attempts", row.attempts}};
  };
  const Json json = {{"schema", "ssrkit-results"},
                     {"schema_version", kResultsSchemaVersion},
                     {"kit_version", report.kit_version},
                     {"started", report.started},
                     {"command", report.command},
                     {"summary", summaryOf(report)},
                     {"devices", listOf(report.devices, deviceOf)},
                     {"checks", listOf(report.checks, checkOf)},
                     {"traces", listOf(report.rows, traceOf)},
                     {"frames", listOf(report.frames, frameOf)},
                     {"geometry", listOf(report.geometries, geometryOf)},
                     {"ledger", ledgerJson(report.ledger)},
                     {"cells", listOf(report.cells, cellOf)},
                     {"unit_tests", unitTestsOf(report.unit_tests)}};
  return jsonText(json, 1) + "\n";
}

Expected<void> writeResultsJson(const std::filesystem::path& path, const RunReport& report) {
  return writeFileAtomically(path, resultsJson(report));
}

}  // namespace ssrkit
