// The kinds of frame, as rows of data: which passes follow the G-buffer and are shared by all traces.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "frame/frame_pass.h"

namespace ssrkit {

struct FrameKind {
  std::string name;
  std::string about;              // one line for people
  std::vector<FramePass> passes;  // after the G-buffer, in order; one of them writes "lit"
  bool has_environment = false;   // its passes sample the environment's maps
  std::string technique;          // what reflections are shown with unless a technique is named
  // By name, the passes of techniques that would count some of this frame's light twice, and the pass that
  // reads and writes the same images in their place.
  std::map<std::string, std::string> draws_instead = {};
};

// "basic" first: what `run` draws.
[[nodiscard]] std::span<const FrameKind> frameKinds();

// Fails with the nearest name and the list.
[[nodiscard]] Expected<const FrameKind*> findFrameKind(std::string_view name);

}  // namespace ssrkit
