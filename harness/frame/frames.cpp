#include "frame/frames.h"

#include "frame/find_row.h"

namespace ssrkit {

namespace {

const std::vector<FrameKind>& table() {
  static const std::vector<FrameKind> rows = {
      {.name = "basic",
       .about = "one G-buffer, lit by Lambert and Blinn-Phong",
       .passes = {{.name = "light", .outputs = {"lit"}}},
       .technique = "mirror"},
      {.name = "full",
       .about = "the whole frame, with everything that a technique may read",
       .passes = {{.name = "light", .outputs = {"lit"}}},
       .technique = "mirror"},
  };
  return rows;
}

}  // namespace

std::span<const FrameKind> frameKinds() {
  return table();
}

Expected<const FrameKind*> findFrameKind(std::string_view name) {
  return findRow(frameKinds(), name, "frame");
}

}  // namespace ssrkit
