// What a module reads and writes, by SPIRV-Cross.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/error.h"
#include "shader/interface.h"

namespace ssrkit {

// Everything declared, sorted by binding, location or id. Structs inside a block are flattened to
// "light.colour" and "lights[2].colour". Fails on what a pass cannot bind: storage images and buffers, loose
// uniforms, arrays of samplers, another set than 0, one binding used twice, row-major matrices, 64-bit types.
[[nodiscard]] Expected<ShaderInterface> reflectSpirv(const std::vector<std::uint32_t>& spirv,
                                                     const std::string& where, const std::string& attempted);

}  // namespace ssrkit
