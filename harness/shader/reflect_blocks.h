// The reflection of std140 blocks. Includes SPIRV-Cross, so only reflect*.cpp include it.
#pragma once

#include <spirv_cross/spirv_cross.hpp>

#include "shader/interface.h"

namespace ssrkit {

// Both throw UnsupportedInterface or spirv_cross::CompilerError.
[[nodiscard]] ScalarType scalarTypeOf(const spirv_cross::SPIRType& type, const std::string& name);
[[nodiscard]] UniformBlock reflectBlock(const spirv_cross::Compiler& compiler,
                                        const spirv_cross::Resource& resource);

// Element count of a one-dimensional array, 0 for no array.
[[nodiscard]] std::uint32_t arrayCount(const spirv_cross::Compiler& compiler,
                                       const spirv_cross::SPIRType& type, const std::string& name);

}  // namespace ssrkit
