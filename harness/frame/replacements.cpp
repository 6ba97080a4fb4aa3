#include "frame/replacements.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "base/text.h"
#include "frame/frames.h"
#include "frame/gbuffer_source.h"
#include "frame/pyramid.h"
#include "frame/shadow_map.h"
#include "frame/stages.h"
#include "frame/techniques.h"
#include "frame/trace_pass.h"
#include "frame/variants.h"

namespace ssrkit {

namespace {

// Every pass, and a stage's name for its trace shaders.
std::vector<std::string> replaceableNames() {
  std::vector<std::string> names = {gbufferPass().name, shadowMapPass().name, shadowMapMaskedPass().name,
                                    pyramidBasePass().name, pyramidReducePass().name};
  const auto add = [&names](const std::vector<FramePass>& passes) {
    for (const FramePass& pass : passes) {
      if (std::ranges::find(names, pass.name) == names.end()) {
        names.push_back(pass.name);
      }
    }
  };
  for (const FrameKind& kind : frameKinds()) {
    add(kind.passes);
  }
  for (const Technique& technique : techniques()) {
    add(technique.before_pyramid);
    add(technique.before_trace);
    add(technique.after_sample);
    add(technique.after_trace);
  }
  add({withoutRayPass()});
  for (const Stage& stage : stages()) {
    names.push_back(stage.name);
    add({tracePass(stage.shader), tracePass(stage.tuned_shader)});
  }
  return names;
}

// The pass that a job draws for a request's trace.
std::string tracePassName(const TraceRequest& request) {
  const auto stage = findStage(request.stage);
  return stage ? tracePass(shaderOf(**stage, request.parameters)).name : "";
}

// A shader that takes no pass's place would leave its author with the kit's own results.
Expected<void> checkIsDrawn(const std::string& pass, const Job& job) {
  std::vector<std::string> drawn;
  for (const TraceRequest& request : job.traces) {
    drawn.push_back(tracePassName(request));
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
  const auto variant = findVariant(job.variant);
  if (!variant) {
    return tl::make_unexpected(variant.error());
  }
  CompileSettings settings{.shader_root = job.shader_root, .replacements = {}, .form = (*variant)->modules};
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
      settings.replacements[tracePass((*stage)->shader).name] = file;
      settings.replacements[tracePass((*stage)->tuned_shader).name] = file;
    }
  }
  return settings;
}

}  // namespace ssrkit
