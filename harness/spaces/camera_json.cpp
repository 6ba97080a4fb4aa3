#include "spaces/camera_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/json_text.h"

namespace ssrkit {

namespace {

using nlohmann::ordered_json;

constexpr const char* kSchema = "ssrkit.camera";
constexpr int kVersion = 1;

ordered_json rowsOf(const glm::dmat4& matrix) {
  ordered_json rows = ordered_json::array();
  for (int row = 0; row < 4; ++row) {
    ordered_json values = ordered_json::array();
    for (int column = 0; column < 4; ++column) {
      values.push_back(matrix[column][row]);
    }
    rows.push_back(values);
  }
  return rows;
}

// What is wrong with the value, or nothing.
std::string readMatrix(const ordered_json& json, const char* key, glm::dmat4& matrix) {
  const auto rows = json.find(key);
  if (rows == json.end() || !rows->is_array() || rows->size() != 4) {
    return fmt::format("'{}' must be 4 rows of 4 numbers", key);
  }
  for (int row = 0; row < 4; ++row) {
    const ordered_json& values = (*rows)[static_cast<std::size_t>(row)];
    if (!values.is_array() || values.size() != 4) {
      return fmt::format("row {} of '{}' must be 4 numbers", row, key);
    }
    for (int column = 0; column < 4; ++column) {
      const ordered_json& value = values[static_cast<std::size_t>(column)];
      if (!value.is_number()) {
        return fmt::format("row {}, column {} of '{}' is not a number", row, column, key);
      }
      matrix[column][row] = value.get<double>();
    }
  }
  return {};
}

std::string readNumber(const ordered_json& json, const char* key, double& number) {
  const auto value = json.find(key);
  if (value == json.end() || !value->is_number()) {
    return fmt::format("'{}' must be a number", key);
  }
  number = value->get<double>();
  return {};
}

// The parser's messages quote the text, which may be no text at all.
std::string printable(std::string text) {
  std::ranges::replace_if(
      text, [](char letter) { return letter < ' ' || letter > '~'; }, '?');
  return text;
}

std::string readSize(const ordered_json& json, Size& size) {
  const auto value = json.find("size");
  if (value == json.end() || !value->is_array() || value->size() != 2 || !(*value)[0].is_number_integer() ||
      !(*value)[1].is_number_integer()) {
    return "'size' must be two whole numbers, width and height";
  }
  // Out of an int's range is out of every image's range: 0 is refused with the right words by validate().
  const auto whole = [](const ordered_json& side) {
    const auto number = side.get<std::int64_t>();
    return number < 0 || number > 1'000'000 ? 0 : static_cast<int>(number);
  };
  size = {whole((*value)[0]), whole((*value)[1])};
  return {};
}

// A renderer need not say what it writes; what it says must be true.
std::string checkSchema(const ordered_json& json) {
  if (!json.is_object()) {
    return "the file is not a JSON object";
  }
  if (const auto schema = json.find("schema"); schema != json.end() && *schema != kSchema) {
    return fmt::format("its 'schema' is not \"{}\"", kSchema);
  }
  if (const auto version = json.find("version"); version != json.end() && *version != kVersion) {
    return fmt::format("its 'version' is not {}, the only one that is read", kVersion);
  }
  return {};
}

std::string readPrevious(const ordered_json& json, std::optional<glm::dmat4>& previous_view_from_world) {
  const char* const key = "previous_view_from_world";
  return json.contains(key) ? readMatrix(json, key, previous_view_from_world.emplace()) : "";
}

}  // namespace

std::string toJson(const Camera& camera) {
  ordered_json json;
  json["schema"] = kSchema;
  json["version"] = kVersion;
  json["size"] = {camera.size.width, camera.size.height};
  json["clip_from_view"] = rowsOf(camera.clip_from_view);
  json["view_from_world"] = rowsOf(camera.view_from_world);
  if (camera.previous_view_from_world) {
    json["previous_view_from_world"] = rowsOf(*camera.previous_view_from_world);
  }
  json["near_m"] = camera.near_m;
  json["far_m"] = camera.far_m;
  json["conventions"] = {{"matrices", "row-major, p_clip = clip_from_view * view_from_world * p_world"},
                         {"view", "+x right, +y up, looking along -z, metres"},
                         {"ndc_z", "0 at near_m, 1 at far_m"},
                         {"pixels", "origin upper left, +y down, texel centres at .5"}};
  return jsonText(json, 2) + "\n";
}

Expected<Camera> cameraFromJson(std::string_view text, const std::string& where) {
  const std::string attempted = "read the camera";
  ordered_json json;
  try {
    json = ordered_json::parse(text);
  } catch (const ordered_json::exception& error) {
    return inputError(attempted, printable(error.what()), where, "write it as JSON, see docs/formats.md");
  }
  if (std::string problem = checkSchema(json); !problem.empty()) {
    return inputError(attempted, std::move(problem), where, "see docs/formats.md");
  }
  Camera camera;
  for (const std::string& problem :
       {readSize(json, camera.size), readMatrix(json, "clip_from_view", camera.clip_from_view),
        readMatrix(json, "view_from_world", camera.view_from_world),
        readPrevious(json, camera.previous_view_from_world), readNumber(json, "near_m", camera.near_m),
        readNumber(json, "far_m", camera.far_m)}) {
    if (!problem.empty()) {
      return inputError(attempted, problem, where, "see docs/formats.md");
    }
  }
  auto valid = validate(camera, attempted);
  valid = valid ? validateRigid(camera, attempted) : valid;
  if (!valid) {
    Error error = valid.error();
    error.where = where;
    return tl::make_unexpected(std::move(error));
  }
  return camera;
}

}  // namespace ssrkit
