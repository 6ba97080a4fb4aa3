// A compiled module, or the error instead of it, as bytes.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/error.h"
#include "shader/compiler.h"

namespace ssrkit {

// Words and interface; dependencies belong to the caller's folders and are left out.
[[nodiscard]] std::string toBytes(const ShaderModule& module);
[[nodiscard]] std::string toBytes(const Error& error);

// Nothing when the bytes are no whole value.
[[nodiscard]] std::optional<ShaderModule> moduleFromBytes(std::string_view bytes);
[[nodiscard]] std::optional<Error> errorFromBytes(std::string_view bytes);

}  // namespace ssrkit
