#include "report/json_parts.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "base/text.h"

namespace ssrkit {

namespace {

Json timeOf(const PassTime& time) {
  return {{"wall_ns", time.wall_ns},
          {"cpu_ns", time.cpu_ns},
          {"device_ns", time.device_ns ? Json(*time.device_ns) : Json(nullptr)}};
}

}  // namespace

Json numberOf(double value) {
  if (std::isnan(value)) {
    return "nan";
  }
  if (std::isinf(value)) {
    return value > 0.0 ? "inf" : "-inf";
  }
  return value;
}

Json numberOf(const std::optional<double>& value) {
  return value ? numberOf(*value) : Json(nullptr);
}

Json parametersOf(const TraceParameters& parameters) {
  Json json = Json::object();
  for (const std::string& parameter : parameterNames()) {
    const std::string text = parameterText(parameters, parameter);
    const std::optional<double> number = parseNumber(text);
    const bool is_integer =
        number && std::isfinite(*number) && text.find_first_not_of("-0123456789") == std::string::npos;
    json[parameter] = is_integer ? Json(static_cast<long long>(*number))
                      : number   ? numberOf(*number)
                                 : Json(text);
  }
  return json;
}

Json sizeOf(Size size) {
  return Json::array({size.width, size.height});
}

Json deviceOf(const DeviceRow& device) {
  const DeviceIdentity& identity = device.identity;
  return {{"id", identity.id},
          {"api", identity.api},
          {"driver", identity.driver},
          {"version", identity.version},
          {"cpu", identity.cpu},
          {"cpu_features", identity.cpu_features},
          {"traits",
           {{"loop_cap", device.traits.loop_cap},
            {"device_timer_usable", device.traits.device_timer_usable},
            {"shader_input", device.traits.shader_input}}}};
}

Json passesOf(const std::vector<PassReport>& passes) {
  Json json = Json::array();
  for (const PassReport& pass : passes) {
    Json steady = Json::array();
    for (const PassTime& time : pass.steady) {
      steady.push_back(timeOf(time));
    }
    json.push_back({{"pass", pass.pass}, {"cold", timeOf(pass.cold)}, {"steady", std::move(steady)}});
  }
  return json;
}

}  // namespace ssrkit
