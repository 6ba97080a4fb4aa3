#include "scene/environment_choice.h"

#include <fmt/format.h>

#include <cmath>

#include "base/text.h"
#include "scene/clean_name.h"

namespace ssrkit {

Expected<EnvironmentChoice> parseEnvironment(const std::string& text, const std::filesystem::path& folder,
                                             const std::string& where) {
  constexpr std::string_view kConstant = "constant:";
  constexpr double kMax = 1000.0;
  if (text.empty() || text.find('\0') != std::string::npos) {
    return inputError("read the environment", "it names no file", where,
                      "write constant:R,G,B or an EXR file's name");
  }
  if (!text.starts_with(kConstant)) {
    return EnvironmentChoice{.file = (folder / text).lexically_normal(), .constant = std::nullopt};
  }
  const std::vector<std::string> numbers = split(text.substr(kConstant.size()), ',');
  glm::vec3 colour(0.0F);
  bool valid = numbers.size() == 3;
  for (int i = 0; valid && i < 3; ++i) {
    const auto number = parseNumber(numbers[static_cast<std::size_t>(i)]);
    valid = number && *number >= 0.0 && *number <= kMax;
    colour[i] = static_cast<float>(number.value_or(0.0));
  }
  if (!valid) {
    return inputError(
        "read the environment",
        fmt::format("'{}' is not constant:R,G,B with numbers from 0 to {}", cleanName(text), kMax), where,
        "write for example constant:0.5,0.5,0.5");
  }
  return EnvironmentChoice{.file = {}, .constant = colour};
}

}  // namespace ssrkit
