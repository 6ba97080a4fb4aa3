#include "report/junit_xml.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <pugixml.hpp>
#include <sstream>
#include <string_view>

#include "base/size.h"
#include "report/check_text.h"
#include "report/plain_utf8.h"

namespace ssrkit {

namespace {

// Checks that no answer fitted name no device.
constexpr const char* kNoDevice = "no-device";

// The element that tells of an outcome; null where the check counts as passed.
const char* elementOf(Outcome outcome) {
  switch (outcome) {
    case Outcome::kFail:
    case Outcome::kXpass:
      return "failure";
    case Outcome::kError:
    case Outcome::kCrash:
    case Outcome::kTimeout:
    case Outcome::kLimiter:
    case Outcome::kMissing:
      return "error";
    case Outcome::kSkip:
    case Outcome::kXfail:
      return "skipped";
    case Outcome::kPass:
    case Outcome::kWarn:
    case Outcome::kFlake:
    case Outcome::kInconclusive:
      return nullptr;
  }
  return "error";
}

void setAttribute(pugi::xml_node node, const char* attribute, const std::string& value) {
  node.append_attribute(attribute).set_value(plainUtf8(value).c_str());
}

void addProperty(pugi::xml_node properties, const char* property, const std::string& value) {
  pugi::xml_node node = properties.append_child("property");
  setAttribute(node, "name", property);
  setAttribute(node, "value", value);
}

// "clutter 320x180 t_0.3m hiz"
std::string caseName(const CheckResult& check) {
  std::string text = check.scene;
  const std::string size = check.size.width > 0 ? sizeText(check.size) : "";
  for (const std::string& part : {size, check.case_name, check.stage}) {
    text += part.empty() ? "" : " " + part;
  }
  return text.empty() ? check.id : text;
}

void addCase(pugi::xml_node suite, const std::string& device, const CheckResult& check) {
  pugi::xml_node node = suite.append_child("testcase");
  setAttribute(node, "name", caseName(check));
  setAttribute(node, "classname", device + "." + check.id);
  // Jenkins' schema takes three decimals.
  setAttribute(node, "time", fmt::format("{:.3f}", check.time_s));
  if (const char* const element = elementOf(check.outcome)) {
    pugi::xml_node outcome = node.append_child(element);
    setAttribute(outcome, "type", name(check.outcome));
    setAttribute(outcome, "message", summaryLine(check));
    outcome.append_child(pugi::node_pcdata).set_value(plainUtf8(check.message).c_str());
  }
}

void addProperties(pugi::xml_node suite, const RunReport& report, const std::string& device,
                   const std::vector<const CheckResult*>& checks) {
  pugi::xml_node properties = suite.append_child("properties");
  addProperty(properties, "kit_version", report.kit_version);
  addProperty(properties, "command", fmt::format("{}", fmt::join(report.command, " ")));
  for (const DeviceRow& row : report.devices) {
    if (row.identity.id == device) {
      addProperty(properties, "api", row.identity.api);
      addProperty(properties, "driver", row.identity.driver);
      addProperty(properties, "version", row.identity.version);
      addProperty(properties, "cpu", row.identity.cpu);
    }
  }
  // A test case has no properties in either schema: what is passed but worth a look is named here.
  for (const CheckResult* check : checks) {
    const bool is_plain = check->outcome == Outcome::kPass || elementOf(check->outcome) != nullptr;
    if (!is_plain) {
      addProperty(properties, name(check->outcome),
                  fmt::format("{}: {}", fullName(*check), summaryLine(*check)));
    }
  }
}

std::string countOf(const std::vector<const CheckResult*>& checks, std::string_view element) {
  return std::to_string(std::ranges::count_if(checks, [&](const CheckResult* check) {
    const char* const own = elementOf(check->outcome);
    return own != nullptr && element == own;
  }));
}

void addSuite(pugi::xml_node suites, const RunReport& report, const std::string& device, std::size_t number) {
  std::vector<const CheckResult*> checks;
  for (const CheckResult& check : report.checks) {
    if ((check.device.empty() ? kNoDevice : check.device) == device) {
      checks.push_back(&check);
    }
  }
  pugi::xml_node suite = suites.append_child("testsuite");
  setAttribute(suite, "name", device);
  setAttribute(suite, "package", "ssrkit");
  setAttribute(suite, "id", std::to_string(number));
  setAttribute(suite, "timestamp", report.started.substr(0, report.started.find('Z')));
  setAttribute(suite, "hostname", "localhost");
  setAttribute(suite, "tests", std::to_string(checks.size()));
  setAttribute(suite, "failures", countOf(checks, "failure"));
  setAttribute(suite, "errors", countOf(checks, "error"));
  setAttribute(suite, "skipped", countOf(checks, "skipped"));
  const double time_s = std::transform_reduce(checks.begin(), checks.end(), 0.0, std::plus{},
                                              [](const CheckResult* check) { return check->time_s; });
  setAttribute(suite, "time", fmt::format("{:.3f}", time_s));
  addProperties(suite, report, device, checks);
  for (const CheckResult* check : checks) {
    addCase(suite, device, *check);
  }
  suite.append_child("system-out");
  suite.append_child("system-err");
}

}  // namespace

std::string junitXml(const RunReport& report) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  pugi::xml_node suites = document.append_child("testsuites");
  std::vector<std::string> devices;
  for (const CheckResult& check : report.checks) {
    const std::string device = check.device.empty() ? kNoDevice : check.device;
    if (std::ranges::find(devices, device) == devices.end()) {
      devices.push_back(device);
    }
  }
  for (std::size_t i = 0; i < devices.size(); ++i) {
    addSuite(suites, report, devices[i], i);
  }
  std::ostringstream stream;
  document.save(stream, " ");
  return stream.str();
}

}  // namespace ssrkit
