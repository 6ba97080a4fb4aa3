#pragma once

#include "base/error.h"
#include "scene/gltf_document.h"
#include "scene/gltf_materials.h"
#include "scene/mesh_triangles.h"

namespace ssrkit {

// Reads meshes[mesh].primitives[primitive]; no triangles come from points and lines. Fails on accessors that
// do not fit and on positions that are not finite.
[[nodiscard]] Expected<MeshTriangles> readPrimitive(GltfDocument& document, const GltfMaterials& materials,
                                                    int mesh, int primitive);

}  // namespace ssrkit
