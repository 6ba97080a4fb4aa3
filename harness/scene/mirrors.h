#pragma once

#include <string>

#include "base/error.h"
#include "scene/gltf_source.h"
#include "scene/scene.h"

namespace ssrkit {

// Decides which materials mirror. With a name, the materials of that name alone; without, those that already
// do, or all of them (with a note) when no triangle has one. Fails on a name that no material has.
[[nodiscard]] Expected<void> chooseMirrors(const GltfSource& source, const std::string& mirror_material,
                                           Scene& scene);

}  // namespace ssrkit
