#include "command/compile.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <utility>
#include <vector>

#include "command/compile_files.h"
#include "command/compile_report.h"
#include "command/output_folder.h"

namespace ssrkit {

namespace {

CompileResult compileFor(const ShaderSource& source, ShaderTarget target, bool optimise) {
  const auto start = std::chrono::steady_clock::now();
  Expected<ShaderModule> module =
      compileShader(source, target, {.form = optimise ? ModuleForm::kOptimised : ModuleForm::kPlain});
  const auto time = std::chrono::steady_clock::now() - start;
  return {target, std::move(module), std::chrono::duration_cast<std::chrono::nanoseconds>(time).count()};
}

// Nothing is written of a shader that does not compile for both.
Expected<std::vector<CompiledFile>> filesOf(const CompileCommandOptions& options,
                                            const std::vector<CompileResult>& results) {
  const bool compiles =
      std::ranges::all_of(results, [](const CompileResult& result) { return result.module.has_value(); });
  if (options.out.empty() || !compiles) {
    return std::vector<CompiledFile>{};
  }
  return writeCompiled(options.out, options.file.filename().string(), results);
}

}  // namespace

Expected<int> compileCommand(const CompileCommandOptions& options) {
  std::error_code code;
  if (!std::filesystem::exists(options.file, code)) {
    return inputError(fmt::format("compile '{}'", options.file.string()), "there is no such file");
  }
  const Expected<ShaderStage> stage = stageOfFile(options.file);
  if (!stage) {
    return tl::make_unexpected(stage.error());
  }
  if (!options.out.empty()) {
    if (auto prepared = prepareFolder(options.out); !prepared) {
      return tl::make_unexpected(prepared.error());
    }
  }
  const ShaderSource source{options.shader_root, std::filesystem::absolute(options.file), *stage, {}};
  std::vector<CompileResult> results;
  for (const ShaderTarget target : {ShaderTarget::kOpenGl, ShaderTarget::kVulkan}) {
    results.push_back(compileFor(source, target, options.optimise));
  }
  const Expected<std::vector<CompiledFile>> files = filesOf(options, results);
  if (!files) {
    return tl::make_unexpected(files.error());
  }
  const std::string file = options.file.string();
  fmt::print("{}", options.json ? compileReportJson(file, results, *files)
                                : compileReportText(file, results, *files, options.use_colour));
  for (const CompileResult& result : results) {
    if (!result.module) {
      return exitCode(result.module.error());
    }
  }
  return 0;
}

}  // namespace ssrkit
