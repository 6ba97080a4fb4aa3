#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "base/error.h"
#include "scene/gltf_source.h"

namespace ssrkit {

// Whether the kit reads what a glTF file says by the extension: one that is required must be among them.
[[nodiscard]] bool isReadExtension(std::string_view name);

// Checks everything of a glTF 2.0 document that the kit uses: the version, the extensions it requires, the
// type of every property, and that every index points into its array. After it, no index needs to be looked
// at again.
[[nodiscard]] Expected<void> checkGltfSchema(const GltfSource& source, const nlohmann::json& root);

}  // namespace ssrkit
