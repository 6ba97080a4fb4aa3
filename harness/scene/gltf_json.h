#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "base/error.h"
#include "scene/gltf_source.h"

namespace ssrkit {

// Parses the JSON of a glTF file. Fails at file:line:column on bad syntax, on nesting over 64 levels and on
// more than 8 million values: a small file must not cost a large memory.
[[nodiscard]] Expected<nlohmann::json> parseGltfJson(const GltfSource& source, const std::string& text);

}  // namespace ssrkit
