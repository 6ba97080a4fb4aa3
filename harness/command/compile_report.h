// How `ssrkit compile` shows its result.
#pragma once

#include <cstdint>
#include <filesystem>
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

// A file that was written of the result.
struct CompiledFile {
  std::filesystem::path path;
  std::string holds;    // "SPIR-V", "GLSL 330"
  std::string devices;  // whose drivers are given this
};

// For people: at most 100 columns, but for files' names.
[[nodiscard]] std::string compileReportText(const std::string& file, std::span<const CompileResult> results,
                                            std::span<const CompiledFile> files, bool use_colour);

// For programs: one JSON object.
[[nodiscard]] std::string compileReportJson(const std::string& file, std::span<const CompileResult> results,
                                            std::span<const CompiledFile> files);

}  // namespace ssrkit
