#include "command/parameters_file.h"

#include <fmt/format.h>

#include <string>
#include <system_error>

#include "base/atomic_file.h"
#include "base/text.h"
#include "scene/defaults.h"

namespace ssrkit {

namespace {

constexpr const char* kName = "parameters.toml";

}  // namespace

Expected<void> writeParametersFile(const std::filesystem::path& folder, const TraceParameters& parameters) {
  std::string text = "# What this scene was traced with; ssrkit run --gbuffer reads it.\n";
  for (const std::string& name : parameterNames()) {
    const std::string value = parameterText(parameters, name);
    text += parseNumber(value) ? fmt::format("{} = {}\n", name, value)
                               : fmt::format("{} = \"{}\"\n", name, value);
  }
  return writeFileAtomically(folder / kName, text);
}

Expected<TraceParameters> parametersBesideCamera(const std::filesystem::path& gbuffer) {
  constexpr int kFoldersWithCamera = 3;
  std::error_code ignored;
  std::filesystem::path folder = std::filesystem::weakly_canonical(gbuffer, ignored);
  for (int i = 1; i < kFoldersWithCamera && !std::filesystem::exists(folder / "camera.json", ignored); ++i) {
    folder = folder.parent_path();
  }
  if (!std::filesystem::exists(folder / kName, ignored)) {
    return TraceParameters{};
  }
  const auto defaults = loadSceneDefaults(folder / kName);
  return defaults ? Expected<TraceParameters>(defaults->parameters) : tl::make_unexpected(defaults.error());
}

}  // namespace ssrkit
