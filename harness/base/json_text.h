#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace ssrkit {

// JSON as every file and every line for programs has it: `indent` spaces a level, -1 for a single line; no
// newline at the end. Bytes that are no UTF-8 (of an argument, a file's name, a driver's message) become
// U+FFFD.
[[nodiscard]] std::string jsonText(const nlohmann::ordered_json& json, int indent);

}  // namespace ssrkit
