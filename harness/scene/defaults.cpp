#include "scene/defaults.h"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/atomic_file.h"
#include "base/text.h"
#include "scene/clean_name.h"

namespace ssrkit {

namespace {

constexpr const char* kAttempted = "read the scene's defaults";

// Everything but the tracing parameters.
const std::vector<std::string>& ownKeys() {
  static const std::vector<std::string> kKeys{"about",       "pictured",        "look_for",
                                              "camera",      "light_direction", "light_radiance",
                                              "sky_horizon", "sky_zenith",      "environment"};
  return kKeys;
}

class DefaultsReader {
 public:
  explicit DefaultsReader(std::filesystem::path file) : file_(std::move(file)) {}

  Expected<SceneDefaults> read(const toml::table& table) {
    for (const auto& [key, value] : table) {
      if (auto set = setKey(key, value); !set) {
        return tl::make_unexpected(set.error());
      }
    }
    if (isThicknessRelativeAlone(written_)) {
      defaults_.parameters.thickness_m = 0.0;
    }
    return std::move(defaults_);
  }

 private:
  [[nodiscard]] std::string placeOf(const toml::source_region& region) const {
    return fmt::format("{}:{}:{}", file_.string(), region.begin.line, region.begin.column);
  }

  [[nodiscard]] tl::unexpected<Error> refuse(const toml::source_region& region, std::string problem,
                                             std::string remedy = {}) const {
    return inputError(kAttempted, std::move(problem), placeOf(region), std::move(remedy));
  }

  Expected<void> setKey(const toml::key& key, const toml::node& value) {
    const std::string name(key.str());
    const auto parameters = parameterNames();
    if (std::find(parameters.begin(), parameters.end(), name) != parameters.end()) {
      return setTraceParameter(name, value);
    }
    for (auto& [text_key, text] :
         {std::pair{"about", &defaults_.about}, std::pair{"pictured", &defaults_.pictured},
          std::pair{"look_for", &defaults_.look_for}, std::pair{"camera", &defaults_.camera}}) {
      if (name == text_key) {
        return setText(name, value, *text);
      }
    }
    for (auto& [colour_key, colour] :
         {std::pair{"light_radiance", &defaults_.light_radiance},
          std::pair{"sky_horizon", &defaults_.sky_horizon}, std::pair{"sky_zenith", &defaults_.sky_zenith}}) {
      if (name == colour_key) {
        return setColour(name, value, *colour);
      }
    }
    if (name == "environment") {
      return setEnvironment(value);
    }
    return name == "light_direction" ? setDirection(value) : unknownKey(key);
  }

  [[nodiscard]] tl::unexpected<Error> unknownKey(const toml::key& key) const {
    std::vector<std::string> known = ownKeys();
    known.insert(known.end(), parameterNames().begin(), parameterNames().end());
    const auto nearest = nearestName(key.str(), known);
    return refuse(key.source(), fmt::format("there is no key '{}'", cleanName(key.str())),
                  nearest ? fmt::format("did you mean '{}'?", *nearest) : "the keys are " + joinNames(known));
  }

  Expected<void> setText(const std::string& name, const toml::node& value, std::string& text) const {
    if (!value.is_string()) {
      return refuse(value.source(), fmt::format("'{}' must be text in quotes", name));
    }
    text = value.as_string()->get();
    return {};
  }

  Expected<void> setTraceParameter(const std::string& name, const toml::node& value) {
    std::string text;
    if (const auto* number = value.as_floating_point()) {
      text = fmt::format("{}", number->get());
    } else if (const auto* whole = value.as_integer()) {
      text = fmt::format("{}", whole->get());
    } else if (const auto* word = value.as_string()) {
      text = word->get();
    } else {
      return refuse(value.source(), fmt::format("'{}' must be a number or text", name));
    }
    written_.emplace_back(name, text);
    return setParameter(defaults_.parameters, name, text, placeOf(value.source()));
  }

  [[nodiscard]] Expected<glm::dvec3> threeNumbers(const std::string& name, const toml::node& value) const {
    const toml::array* numbers = value.as_array();
    glm::dvec3 vector(0.0);
    bool valid = numbers != nullptr && numbers->size() == 3;
    for (int i = 0; valid && i < 3; ++i) {
      const auto number = numbers->get(static_cast<std::size_t>(i))->value<double>();
      valid = number && std::isfinite(*number);
      vector[i] = number.value_or(0.0);
    }
    if (!valid) {
      return refuse(value.source(), fmt::format("'{}' must be three numbers in brackets", name));
    }
    return vector;
  }

  Expected<void> setColour(const std::string& name, const toml::node& value,
                           std::optional<glm::vec3>& colour) const {
    const auto numbers = threeNumbers(name, value);
    if (!numbers) {
      return tl::make_unexpected(numbers.error());
    }
    constexpr double kMax = 1000.0;
    if (std::min({numbers->x, numbers->y, numbers->z}) < 0.0 ||
        std::max({numbers->x, numbers->y, numbers->z}) > kMax) {
      return refuse(value.source(), fmt::format("'{}' must lie between 0 and {}", name, kMax));
    }
    colour = glm::vec3(*numbers);
    return {};
  }

  Expected<void> setEnvironment(const toml::node& value) {
    std::string text;
    if (auto read = setText("environment", value, text); !read) {
      return read;
    }
    return parseEnvironment(text, file_.parent_path(), placeOf(value.source()))
        .map([&](EnvironmentChoice choice) { defaults_.environment = std::move(choice); });
  }

  Expected<void> setDirection(const toml::node& value) {
    const auto numbers = threeNumbers("light_direction", value);
    if (!numbers) {
      return tl::make_unexpected(numbers.error());
    }
    const double length = glm::length(*numbers);
    if (!(length > 0.0) || !std::isfinite(length)) {
      return refuse(value.source(), "'light_direction' must not be all zeros");
    }
    defaults_.light_direction_world = *numbers / length;
    return {};
  }

  std::filesystem::path file_;
  SceneDefaults defaults_;
  ParameterList written_;
};

}  // namespace

Expected<SceneDefaults> loadSceneDefaults(const std::filesystem::path& file) {
  constexpr std::size_t kMaxBytes = 1 << 20;
  const auto text = readFile(file, kMaxBytes);
  if (!text) {
    return inputError(kAttempted, text.error().problem, file.string(), text.error().remedy);
  }
  try {
    return DefaultsReader(file).read(toml::parse(*text, file.string()));
  } catch (const toml::parse_error& error) {
    const auto& begin = error.source().begin;
    return inputError(kAttempted, cleanName(error.description()),
                      fmt::format("{}:{}:{}", file.string(), begin.line, begin.column));
  }
}

std::filesystem::path defaultsFileOf(const std::filesystem::path& scene_file) {
  std::filesystem::path file = scene_file;
  return file.replace_extension(".toml");
}

void applyLook(const SceneDefaults& defaults, Scene& scene) {
  DirectionalLight& light = scene.directional_lights.front();
  if (defaults.light_direction_world) {
    light.direction_world = *defaults.light_direction_world;
    light.tree_node = -1;  // the direction holds at all times
  }
  light.radiance = defaults.light_radiance.value_or(light.radiance);
  scene.sky_horizon = defaults.sky_horizon.value_or(scene.sky_horizon);
  scene.sky_zenith = defaults.sky_zenith.value_or(scene.sky_zenith);
  scene.environment = defaults.environment.value_or(scene.environment);
}

}  // namespace ssrkit
