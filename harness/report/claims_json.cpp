#include <nlohmann/json.hpp>

#include "base/json_text.h"
#include "report/claims_report.h"
#include "report/json_parts.h"

namespace ssrkit {

namespace {

Json histogramOf(const CheckResult& check) {
  Json json = Json::array();
  for (const HistogramBin& bin : check.histogram) {
    json.push_back({{"label", bin.label}, {"count", bin.count}});
  }
  return json;
}

Json figureOf(const ClaimFigure& figure) {
  const CheckResult& check = figure.check;
  return {
      {"id", check.id},
      {"scene", check.scene},
      {"device", check.device},
      {"stage", check.stage},
      {"size", sizeOf(check.size)},
      {"case", check.case_name},
      {"metric", check.metric},
      {"value", numberOf(check.value)},
      {"unit", check.unit},
      {"interval",
       check.interval ? Json::array({check.interval->first, check.interval->second}) : Json(nullptr)},
      {"compared", check.compared},
      {"confirmed", {{"min", numberOf(check.min)}, {"max", numberOf(check.max)}}},
      {"refuted", {{"below", numberOf(figure.refuting.below)}, {"above", numberOf(figure.refuting.above)}}},
      {"decides", figure.decides},
      {"verdict", figure.decides ? Json(name(figure.verdict)) : Json(nullptr)},
      {"remark", check.remark},
      {"histogram", histogramOf(check)}};
}

Json passTimesOf(const ClaimReport& report) {
  Json json = Json::array();
  for (const FrameRow& frame : report.frames) {
    json.push_back({{"scene", frame.scene},
                    {"device", frame.device},
                    {"size", sizeOf(frame.size)},
                    {"stage", ""},
                    {"case", ""},
                    {"passes", passesOf(frame.passes)}});
  }
  for (const RunRow& row : report.rows) {
    json.push_back({{"scene", row.scene},
                    {"device", row.device},
                    {"size", sizeOf(row.size)},
                    {"stage", row.stage},
                    {"case", row.case_name},
                    {"passes", passesOf(row.passes)}});
  }
  return json;
}

Json claimOf(const ClaimReport& report) {
  Json figures = Json::array();
  for (const ClaimFigure& figure : report.result.figures) {
    figures.push_back(figureOf(figure));
  }
  return {{"name", report.claim.name},
          {"source", report.claim.source},
          {"says", report.claim.says},
          {"hypothesis", report.claim.test.about},
          {"verdict", name(report.result.verdict)},
          {"noted", name(report.claim.finding)},
          {"why", verdictText(report)},
          {"again", report.again},
          {"figures", std::move(figures)},
          {"times", passTimesOf(report)}};
}

}  // namespace

std::string claimsJson(const ClaimsReport& report) {
  Json devices = Json::array();
  for (const DeviceRow& device : report.devices) {
    devices.push_back(deviceOf(device));
  }
  Json claims = Json::array();
  for (const ClaimReport& claim : report.claims) {
    claims.push_back(claimOf(claim));
  }
  const Json json = {{"schema", "ssrkit-claims"},         {"schema_version", kClaimsSchemaVersion},
                     {"kit_version", report.kit_version}, {"started", report.started},
                     {"command", report.command},         {"summary", verdictCounts(report)},
                     {"devices", std::move(devices)},     {"claims", std::move(claims)}};
  return jsonText(json, 1) + "\n";
}

}  // namespace ssrkit
