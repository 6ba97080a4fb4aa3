#pragma once

#include <nlohmann/json_fwd.hpp>

#include "base/error.h"
#include "scene/gltf_source.h"

namespace ssrkit {

// Checks everything of a glTF 2.0 document that the kit uses: the version, the extensions it requires, the
// type of every property, and that every index points into its array. After it, no index needs to be looked
// at again.
[[nodiscard]] Expected<void> checkGltfSchema(const GltfSource& source, const nlohmann::json& root);

}  // namespace ssrkit
