#include "frame/frames.h"

#include "frame/find_row.h"

namespace ssrkit {

namespace {

// Metres within which surfaces shade each other, how far a column goes on, and points a pixel.
const std::map<std::string, UniformConstant> kAo = {
    {"ao_radius_m", 0.5}, {"ao_thickness_m", 0.5}, {"ao_sample_count", 8}};

const std::vector<FrameKind>& frameKindTable() {
  static const std::vector<FrameKind> rows = {
      {.name = "basic",
       .about = "one G-buffer, lit by Lambert and Blinn-Phong",
       .passes = {{.name = "light", .outputs = {"lit"}}},
       .technique = "mirror"},
      {.name = "full",
       .about = "the whole frame, with everything that a technique may read",
       .passes = {{.name = "shadow", .outputs = {"shadow"}, .where_surfaces = true, .clears = {"shadow"}},
                  {.name = "ao",
                   .outputs = {"ao_noisy"},
                   .constants = kAo,
                   .where_surfaces = true,
                   .clears = {"ao_noisy"}},
                  {.name = "ao_blur_across",
                   .outputs = {"ao_blurred"},
                   .constants = {{"ao_blur_down", 0}},
                   .shader = "ao_blur.frag",
                   .where_surfaces = true,
                   .clears = {"ao_blurred"}},
                  {.name = "ao_blur_down",
                   .outputs = {"ao"},
                   .inputs = {{"ao_noisy", "ao_blurred"}},
                   .constants = {{"ao_blur_down", 1}},
                   .shader = "ao_blur.frag",
                   .where_surfaces = true,
                   .clears = {"ao"}},
                  {.name = "light_ggx", .outputs = {"lit", "lit_base"}}},
       .has_environment = true,
       .technique = "replace",
       // Its lit image holds the environment's specular reflection: what a ray found takes its place.
       .draws_instead = {{"composite", "composite_replace"}}},
  };
  return rows;
}

}  // namespace

std::span<const FrameKind> frameKinds() {
  return frameKindTable();
}

Expected<const FrameKind*> findFrameKind(std::string_view name) {
  return findRow(frameKinds(), name, "frame");
}

}  // namespace ssrkit
