// How `ssrkit compile` shows its result.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "base/error.h"
#include "shader/compiler.h"

namespace ssrkit {

// Of `compile --json` (docs/formats.md); raised when a reader of the older version would be misled.
inline constexpr int kCompileSchemaVersion = 1;

struct CompileResult {
  ShaderTarget target = ShaderTarget::kOpenGl;
  Expected<ShaderModule> module;
  std::int64_t wall_ns = 0;
};

// For people: at most 100 columns.
[[nodiscard]] std::string compileReportText(const std::string& file, std::span<const CompileResult> results,
                                            bool use_colour);

// For programs: one JSON object.
[[nodiscard]] std::string compileReportJson(const std::string& file, std::span<const CompileResult> results);

}  // namespace ssrkit
