#include "conform/cell_record.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>

#include "base/json_text.h"
#include "conform/json_fields.h"
#include "report/json_parts.h"
#include "report/ledger_json.h"

namespace ssrkit {

namespace {

constexpr const char* kCellSchema = "ssrkit-cell";
constexpr int kCellVersion = 3;

constexpr int kHexadecimal = 16;

constexpr std::array kGravestFirst = {
    Outcome::kCrash, Outcome::kTimeout, Outcome::kLimiter, Outcome::kError,        Outcome::kFail,
    Outcome::kXpass, Outcome::kMissing, Outcome::kFlake,   Outcome::kInconclusive, Outcome::kXfail,
    Outcome::kWarn,  Outcome::kPass,    Outcome::kSkip};
static_assert(kGravestFirst.size() == kOutcomeCount);

// Two hexadecimal digits a dot.
Json mapJson(const std::optional<FindingMap>& map) {
  return map ? Json{{"size", sizeOf(map->size)}, {"dots", fmt::format("{:02x}", fmt::join(map->dots, ""))}}
             : Json(nullptr);
}

std::optional<FindingMap> mapOf(const JsonFields& fields) {
  if (fields.json("finding_map").is_null()) {
    return std::nullopt;
  }
  const JsonFields map = fields.object("finding_map");
  FindingMap read{.size = map.size("size"), .dots = {}};
  const std::string dots = map.text("dots");
  for (std::size_t at = 0; at + 1 < dots.size(); at += 2) {
    std::uint8_t dot = 0;
    const char* const end = dots.data() + at + 2;
    if (std::from_chars(dots.data() + at, end, dot, kHexadecimal).ptr != end) {
      throw JsonFields::BadField("'dots' is no list of hexadecimal numbers");
    }
    read.dots.push_back(dot);
  }
  const bool is_whole = read.size.width > 0 && read.size.height > 0 &&
                        read.dots.size() == static_cast<std::size_t>(read.size.width) *
                                                static_cast<std::size_t>(read.size.height);
  if (!is_whole || dots.size() != 2 * read.dots.size()) {
    throw JsonFields::BadField("'dots' are not as many as 'size' says");
  }
  return read;
}

Json parametersJson(const std::optional<TraceParameters>& parameters) {
  if (!parameters) {
    return nullptr;
  }
  Json json = Json::object();
  for (const std::string& parameter : parameterNames()) {
    json[parameter] = parameterText(*parameters, parameter);
  }
  return json;
}

std::optional<TraceParameters> parametersOf(const JsonFields& fields) {
  if (fields.json("parameters").is_null()) {
    return std::nullopt;
  }
  const JsonFields texts = fields.object("parameters");
  TraceParameters parameters;
  for (const std::string& parameter : parameterNames()) {
    if (const auto set = setParameter(parameters, parameter, texts.text(parameter.c_str()), ""); !set) {
      throw JsonFields::BadField(set.error().problem);
    }
  }
  return parameters;
}

Json checkJson(const CheckResult& check) {
  Json histogram = Json::array();
  for (const HistogramBin& bin : check.histogram) {
    histogram.push_back({{"label", bin.label}, {"count", bin.count}});
  }
  Json interval = nullptr;
  if (check.interval) {
    interval = {numberOf(check.interval->first), numberOf(check.interval->second)};
  }
  return {{"id", check.id},
          {"scene", check.scene},
          {"device", check.device},
          {"stage", check.stage},
          {"size", sizeOf(check.size)},
          {"case", check.case_name},
          {"parameters", parametersJson(check.parameters)},
          {"outcome", name(check.outcome)},
          {"metric", check.metric},
          {"value", numberOf(check.value)},
          {"max", numberOf(check.max)},
          {"min", numberOf(check.min)},
          {"unit", check.unit},
          {"interval", std::move(interval)},
          {"compared", check.compared},
          {"remark", check.remark},
          {"histogram", std::move(histogram)},
          {"message", check.message},
          {"repro", check.repro},
          {"finding_map", mapJson(check.finding_map)}};
}

CheckResult checkOf(const JsonFields& fields) {
  CheckResult check;
  check.id = fields.text("id");
  check.scene = fields.text("scene");
  check.device = fields.text("device");
  check.stage = fields.text("stage");
  check.size = fields.size("size");
  check.case_name = fields.text("case");
  check.parameters = parametersOf(fields);
  check.outcome = fields.outcome("outcome");
  check.metric = fields.text("metric");
  check.value = fields.number("value");
  check.max = fields.number("max");
  check.min = fields.number("min");
  check.unit = fields.text("unit");
  if (const auto ends = fields.numbers("interval"); ends.size() == 2) {
    check.interval = {ends[0], ends[1]};
  }
  check.compared = fields.count("compared");
  check.remark = fields.text("remark");
  for (const JsonFields& bin : fields.objects("histogram")) {
    check.histogram.push_back({bin.text("label"), bin.count("count")});
  }
  check.message = fields.text("message");
  check.repro = fields.text("repro");
  check.finding_map = mapOf(fields);
  return check;
}

}  // namespace

void dropMaps(CellRecord& record, std::size_t& kept) {
  constexpr std::size_t kMost = 100;
  for (CheckResult& check : record.checks) {
    if (check.finding_map && ++kept > kMost) {
      check.finding_map.reset();
    }
  }
}

Outcome gravestOutcome(const std::vector<CheckResult>& checks) {
  for (const Outcome outcome : kGravestFirst) {
    if (std::ranges::find(checks, outcome, &CheckResult::outcome) != checks.end()) {
      return outcome;
    }
  }
  return Outcome::kMissing;
}

Outcome outcomeOf(const CellRecord& record) {
  return gravestOutcome(record.checks);
}

std::string toJson(const CellRecord& record) {
  Json checks = Json::array();
  for (const CheckResult& check : record.checks) {
    checks.push_back(checkJson(check));
  }
  const Json json = {{"schema", kCellSchema},
                     {"schema_version", kCellVersion},
                     {"id", record.id},
                     {"inputs", record.inputs},
                     {"outcome", name(outcomeOf(record))},
                     {"time_s", record.time_s},
                     {"attempts", record.attempts},
                     {"checks", std::move(checks)},
                     {"ledger", ledgerJson(record.ledger)}};
  return jsonText(json, 1) + "\n";
}

Expected<CellRecord> readCellRecord(std::string_view json, const std::string& file) {
  return readJsonObject(json, file, kCellSchema, kCellVersion, [](const JsonFields& fields) {
    CellRecord record;
    record.id = fields.text("id");
    record.inputs = fields.text("inputs");
    record.time_s = fields.number("time_s").value_or(0.0);
    record.attempts = static_cast<int>(fields.count("attempts"));
    for (const JsonFields& check : fields.objects("checks")) {
      record.checks.push_back(checkOf(check));
    }
    auto ledger = ledgerFromJson(fields.json("ledger"), "ledger");
    if (!ledger) {
      throw JsonFields::BadField(ledger.error().problem);
    }
    record.ledger = std::move(*ledger);
    return record;
  });
}

}  // namespace ssrkit
