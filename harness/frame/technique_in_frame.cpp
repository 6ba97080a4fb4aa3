#include "frame/technique_in_frame.h"

#include <fmt/format.h>

#include <algorithm>

namespace ssrkit {

namespace {

// The row that does the same with this frame's light: "ggx_16" is "replace_ggx_16" where reflections replace
// the environment's.
std::string counterpartHint(const Technique& technique, const FrameKind& kind) {
  const std::string name = fmt::format("{}_{}", kind.technique, technique.name);
  const auto found = std::ranges::find(techniques(), name, &Technique::name);
  return found != techniques().end() && found->frame == kind.name
             ? fmt::format("'{}' does the same there", name)
             : fmt::format("choose --frame {} or another technique", technique.frame);
}

}  // namespace

Expected<Technique> inFrame(const Technique& technique, const FrameKind& kind) {
  if (!technique.frame.empty() && technique.frame != kind.name) {
    return inputError(fmt::format("draw the technique '{}' in the frame '{}'", technique.name, kind.name),
                      fmt::format("it needs the frame '{}'", technique.frame), "",
                      counterpartHint(technique, kind));
  }
  Technique drawn = technique;
  for (FramePass& pass : drawn.after_trace) {
    if (const auto instead = kind.draws_instead.find(pass.name); instead != kind.draws_instead.end()) {
      pass.name = instead->second;
    }
  }
  return drawn;
}

}  // namespace ssrkit
