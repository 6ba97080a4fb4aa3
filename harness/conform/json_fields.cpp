#include "conform/json_fields.h"

#include <fmt/format.h>

#include <limits>

namespace ssrkit {

namespace {

using Json = JsonFields::Json;

double numberFrom(const Json& value) {
  if (value.is_number()) {
    return value.get<double>();
  }
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const std::string word = value.is_string() ? value.get<std::string>() : "";
  if (word == "inf" || word == "-inf") {
    return word == "inf" ? kInfinity : -kInfinity;
  }
  if (word == "nan") {
    return std::numeric_limits<double>::quiet_NaN();
  }
  throw JsonFields::BadField("a number was expected, not " + value.dump());
}

const Json& require(bool is_right, const Json& value, const char* key, const char* kind) {
  if (!is_right) {
    throw JsonFields::BadField(fmt::format("its '{}' is no {}", key, kind));
  }
  return value;
}

}  // namespace

JsonFields::JsonFields(const Json& object) : object_(&object) {
  if (!object.is_object()) {
    throw BadField("an object was expected");
  }
}

const Json& JsonFields::at(const char* key) const {
  const auto found = object_->find(key);
  if (found == object_->end()) {
    throw BadField(fmt::format("it has no '{}'", key));
  }
  return *found;
}

std::string JsonFields::text(const char* key) const {
  return require(at(key).is_string(), at(key), key, "text").get<std::string>();
}

std::size_t JsonFields::count(const char* key) const {
  return require(at(key).is_number_unsigned(), at(key), key, "count").get<std::size_t>();
}

bool JsonFields::flag(const char* key) const {
  return require(at(key).is_boolean(), at(key), key, "truth value").get<bool>();
}

std::optional<double> JsonFields::number(const char* key) const {
  return at(key).is_null() ? std::nullopt : std::optional(numberFrom(at(key)));
}

std::vector<double> JsonFields::numbers(const char* key) const {
  std::vector<double> values;
  if (!at(key).is_null()) {
    for (const Json& value : require(at(key).is_array(), at(key), key, "list")) {
      values.push_back(numberFrom(value));
    }
  }
  return values;
}

std::vector<std::string> JsonFields::texts(const char* key) const {
  std::vector<std::string> values;
  for (const Json& value : require(at(key).is_array(), at(key), key, "list")) {
    values.push_back(require(value.is_string(), value, key, "list of texts").get<std::string>());
  }
  return values;
}

Size JsonFields::size(const char* key) const {
  const std::vector<double> sides = numbers(key);
  require(sides.size() == 2, at(key), key, "size");
  return {static_cast<int>(sides[0]), static_cast<int>(sides[1])};
}

Outcome JsonFields::outcome(const char* key) const {
  const auto outcome = outcomeFromName(text(key));
  require(outcome.has_value(), at(key), key, "outcome");
  return *outcome;
}

JsonFields JsonFields::object(const char* key) const {
  return JsonFields(at(key));
}

std::vector<JsonFields> JsonFields::objects(const char* key) const {
  std::vector<JsonFields> values;
  for (const Json& value : require(at(key).is_array(), at(key), key, "list")) {
    values.emplace_back(value);
  }
  return values;
}

}  // namespace ssrkit
