#include "frame/replacements.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "base/text.h"
#include "frame/stages.h"
#include "frame/tracing.h"

namespace ssrkit {

namespace {

// Every pass, and a stage's name for its trace shaders.
std::vector<std::string> replaceableNames() {
  std::vector<std::string> names = {"gbuffer",        "light",   "pyramid_base",
                                    "pyramid_reduce", "resolve", "composite"};
  for (const Stage& stage : stages()) {
    names.push_back(stage.name);
    names.push_back(traceStep(stage.shader).row.name);
    names.push_back(traceStep(stage.tuned_shader).row.name);
  }
  return names;
}

// The pass that a job draws for a request's trace.
std::string tracePass(const TraceRequest& request) {
  const auto stage = findStage(request.stage);
  return stage ? traceStep(shaderOf(**stage, request.parameters)).row.name : "";
}

// A shader that takes no pass's place would leave its author with the kit's own results.
Expected<void> checkIsDrawn(const std::string& pass, const Job& job) {
  std::vector<std::string> drawn;
  for (const TraceRequest& request : job.traces) {
    drawn.push_back(tracePass(request));
    if (pass == request.stage || pass == drawn.back()) {
      return {};
    }
  }
  const bool is_trace = findStage(pass).has_value() || pass.starts_with("trace_");
  if (!is_trace) {
    return {};
  }
  return inputError(fmt::format("replace the pass '{}'", pass), "this run does not draw it", "",
                    "its trace passes are " + joinNames(drawn));
}

}  // namespace

Expected<CompileSettings> compileSettings(const Job& job) {
  CompileSettings settings{
      .shader_root = job.shader_root, .replacements = {}, .optimise = job.optimise_spirv};
  const std::vector<std::string> names = replaceableNames();
  for (const ShaderReplacement& replacement : job.replacements) {
    if (std::ranges::find(names, replacement.pass) == names.end()) {
      const auto nearest = nearestName(replacement.pass, names);
      return inputError(
          fmt::format("replace the pass '{}'", replacement.pass), "there is no such pass", "",
          nearest ? fmt::format("did you mean '{}'?", *nearest) : "the passes are " + joinNames(names));
    }
    if (const auto is_drawn = checkIsDrawn(replacement.pass, job); !is_drawn) {
      return tl::make_unexpected(is_drawn.error());
    }
    const std::filesystem::path file = std::filesystem::absolute(replacement.file);
    settings.replacements[replacement.pass] = file;
    if (const auto stage = findStage(replacement.pass); stage) {
      settings.replacements[traceStep((*stage)->shader).row.name] = file;
      settings.replacements[traceStep((*stage)->tuned_shader).row.name] = file;
    }
  }
  return settings;
}

}  // namespace ssrkit
