// camera.json of docs/formats.md: what a G-buffer was seen with.
#pragma once

#include <string>
#include <string_view>

#include "spaces/camera.h"

namespace ssrkit {

[[nodiscard]] std::string toJson(const Camera& camera);

// Strict: every key must be there but `schema` and `version`, which must be the kit's where they are, and
// `previous_view_from_world`. Matrices are 4 x 4 row-major numbers. `where` names the file.
[[nodiscard]] Expected<Camera> cameraFromJson(std::string_view text, const std::string& where);

}  // namespace ssrkit
