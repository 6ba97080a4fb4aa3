// The unit of the conformance matrix: one test over one scene at one size on one device.
#pragma once

#include <string>
#include <string_view>

#include "base/size.h"

namespace ssrkit {

struct Cell {
  std::string test;    // a test file's id: "trace.bits"
  std::string scene;   // "clutter"
  Size size;           // texels
  std::string device;  // "gl-osmesa"

  bool operator==(const Cell&) const = default;
};

// "trace.bits/clutter/64x36/gl-osmesa": stable from run to run and safe as a path. Only a-z, 0-9, '.', '_',
// '-' stand between the slashes; anything else in a name becomes '-'.
[[nodiscard]] std::string cellId(const Cell& cell);

// The id without its device: cells of one group are judged against each other, so they run together.
[[nodiscard]] std::string groupId(const Cell& cell);

// Whether the glob (fnmatch's *, ?, [...]; * also crosses slashes) matches the whole id, or all of it up to
// one of its slashes: "trace.bits", "trace.bits/clutter" and "*/gl-zink" each name cells.
[[nodiscard]] bool matchesCell(const std::string& glob, const std::string& id);

}  // namespace ssrkit
