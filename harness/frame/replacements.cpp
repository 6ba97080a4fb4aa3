#include "frame/replacements.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
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

// The passes that a replacement of this name is for: a stage has two.
std::vector<std::string> passesNamed(const std::string& name) {
  const auto stage = findStage(name);
  return stage ? std::vector{tracePass((*stage)->shader).name, tracePass((*stage)->tuned_shader).name}
               : std::vector{name};
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
    const std::filesystem::path file = std::filesystem::absolute(replacement.file);
    for (const std::string& pass : passesNamed(replacement.pass)) {
      settings.replacements[pass] = file;
    }
  }
  return settings;
}

Expected<void> checkReplacementsTookPlace(const std::vector<ShaderReplacement>& replacements,
                                          const std::set<std::string>& drawn_passes) {
  const auto is_drawn = [&](const std::string& pass) { return drawn_passes.contains(pass); };
  for (const ShaderReplacement& replacement : replacements) {
    if (!std::ranges::any_of(passesNamed(replacement.pass), is_drawn)) {
      std::vector<std::string> drawn;
      std::ranges::copy_if(replaceableNames(), std::back_inserter(drawn), is_drawn);
      return inputError(fmt::format("replace the pass '{}'", replacement.pass), "this run does not draw it",
                        "", "its passes are " + joinNames(drawn));
    }
  }
  return {};
}

}  // namespace ssrkit
