#pragma once

#include "base/error.h"
#include "scene/gltf_document.h"
#include "scene/scene.h"

namespace ssrkit {

// Decodes one image of the file to 8-bit RGBA. Only PNG and JPEG, at most 16384 texels a side and 256 MiB
// decoded; the size is read from the header before anything is decoded. The name and the wrap modes are the
// caller's.
[[nodiscard]] Expected<Texture> decodeGltfImage(const GltfDocument& document, int image);

}  // namespace ssrkit
