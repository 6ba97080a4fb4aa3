// What `ssrkit compile` calls the parts of an interface, in its text and in its JSON.
#pragma once

#include <string>

#include "shader/compiler.h"

namespace ssrkit {

[[nodiscard]] std::string apiName(ShaderTarget target);
[[nodiscard]] std::string scalarName(ScalarType type);
[[nodiscard]] std::string samplerName(SamplerKind kind);

}  // namespace ssrkit
