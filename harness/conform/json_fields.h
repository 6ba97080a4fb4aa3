// Reads back the JSON that the kit wrote itself: strict, every surprise is one error that names the file.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/size.h"
#include "check/outcome.h"

namespace ssrkit {

// One object's members by name. A member that is not there or of another kind throws BadField; only
// readJsonObject catches it, so that no exception leaves this room.
class JsonFields {
 public:
  using Json = nlohmann::ordered_json;

  struct BadField : std::runtime_error {
    using std::runtime_error::runtime_error;
  };

  explicit JsonFields(const Json& object);

  [[nodiscard]] std::string text(const char* key) const;
  [[nodiscard]] std::size_t count(const char* key) const;
  [[nodiscard]] bool flag(const char* key) const;
  [[nodiscard]] std::optional<double> number(const char* key) const;  // none for null; "inf", "-inf", "nan"
  [[nodiscard]] std::vector<double> numbers(const char* key) const;   // empty for null
  [[nodiscard]] std::vector<std::string> texts(const char* key) const;
  [[nodiscard]] Size size(const char* key) const;
  [[nodiscard]] Outcome outcome(const char* key) const;
  [[nodiscard]] JsonFields object(const char* key) const;
  [[nodiscard]] std::vector<JsonFields> objects(const char* key) const;
  [[nodiscard]] const Json& json(const char* key) const { return at(key); }  // whatever it is

 private:
  [[nodiscard]] const Json& at(const char* key) const;
  const Json* object_;
};

// Parses `json`, requires its schema and version, and gives what `read` makes of it.
template <class Read>
[[nodiscard]] auto readJsonObject(std::string_view json, const std::string& file, std::string_view schema,
                                  int version, const Read& read)
    -> Expected<decltype(read(std::declval<JsonFields>()))> {
  try {
    const auto document = JsonFields::Json::parse(json);
    const JsonFields fields(document);
    if (fields.text("schema") != schema ||
        fields.count("schema_version") != static_cast<std::size_t>(version)) {
      throw JsonFields::BadField("it was written by another version of the kit, or is another kind of file");
    }
    return read(fields);
  } catch (const std::exception& exception) {
    return inputError("read a result of an earlier run", exception.what(), file, "run that cell again");
  }
}

}  // namespace ssrkit
