#include "frame/composite_techniques.h"

#include "frame/shared_passes.h"

namespace ssrkit {

namespace {

FramePass composite(const std::string& reflection) {
  return {.name = "composite", .outputs = {"composite"}, .inputs = {{"reflection", reflection}}};
}

FramePass compositeReplace(const std::string& reflection) {
  return {.name = "composite_replace", .outputs = {"composite"}, .inputs = {{"reflection", reflection}}};
}

// Sharp reflections by their confidence over a copy of `lit`: nothing is computed where no ray starts.
std::vector<FramePass> replaceByConfidence() {
  FramePass replaced = compositeReplace("reflection_weighed");
  replaced.where_rays_start = true;
  return {resolvePass(),
          confidencePass(),
          {.name = "composite_base",
           .outputs = {"composite"},
           .inputs = {{"source", "lit"}},
           .shader = "copy.frag"},
          std::move(replaced)};
}

// The passes with one more, which puts what they made into the picture.
std::vector<FramePass> endingWith(std::vector<FramePass> passes, FramePass last) {
  passes.push_back(std::move(last));
  return passes;
}

// Along x, then along y; an image cannot be read and written at once.
std::vector<FramePass> blurPair(const std::string& name, const std::string& source, const std::string& output,
                                int narrow) {
  const FramePass along_x{.name = name + "_x",
                          .outputs = {"reflection_blurred_x"},
                          .inputs = {{"source", source}},
                          .constants = {{"along_y", 0}, {"narrow", narrow}},
                          .shader = "gloss_blur.frag"};
  FramePass along_y = along_x;
  along_y.name = name + "_y";
  along_y.outputs = {output};
  along_y.inputs = {{"source", "reflection_blurred_x"}};
  along_y.constants["along_y"] = 1;
  return {along_x, along_y};
}

// Ends with the image reflection_weighed.
std::vector<FramePass> coneMips() {
  return {{.name = "copy_lit", .outputs = {"lit_mips"}, .inputs = {{"source", "lit"}}, .shader = "copy.frag"},
          {.name = "mips_reduce", .outputs = {"lit_mips"}, .fills_mips = true},
          {.name = "resolve_cone", .outputs = {"reflection"}},
          confidencePass()};
}

// Ends with the image reflection_blurred_wide.
std::vector<FramePass> glossBlur() {
  std::vector<FramePass> passes = {
      resolvePass(),
      confidencePass(),
      {.name = "blur_guide", .outputs = {"blur_guide"}, .constants = {{"max_radius_px", 48.0}}}};
  for (const auto& pair : {blurPair("blur_narrow", "reflection_weighed", "reflection_blurred", 1),
                           blurPair("blur_wide", "reflection_blurred", "reflection_blurred_wide", 0)}) {
    passes.insert(passes.end(), pair.begin(), pair.end());
  }
  return passes;
}

}  // namespace

std::vector<Technique> compositeTechniques() {
  return {
      {.name = "mirror",
       .about = "what each ray hit, weighted by Fresnel; the sky where it hit nothing",
       .after_trace = {resolvePass(), {.name = "composite", .outputs = {"composite"}}}},
      {.name = "confidence",
       .about = "mirror, faded where the screen's knowledge ends",
       .after_trace = {resolvePass(), confidencePass(), composite("reflection_weighed")}},
      {.name = "additive",
       .about = "adds the hit's colour by a visibility from specular and shininess (INF584)",
       .after_trace = {resolvePass(),
                       {.name = "visibility", .outputs = {"visibility"}},
                       {.name = "composite_additive", .outputs = {"composite"}}}},
      {.name = "metallic",
       .about = "adds the hit's colour by metalness (KongEngine)",
       .after_trace = {resolvePass(), {.name = "composite_metallic", .outputs = {"composite"}}}},
      {.name = "metal_mask",
       .about = "traces metals only, and blends by Fresnel and the hit's distance from the screen's centre",
       .before_trace = {{.name = "metal_mask", .outputs = {"material_masked"}}},
       .trace_inputs = {{"material", "material_masked"}},
       .after_trace = {resolvePass(), {.name = "composite_masked", .outputs = {"composite"}}}},
      {.name = "replace",
       .about =
           "each reflection in the place of the environment's, in the metallic-roughness sum, by confidence",
       .frame = "full",
       .after_trace = replaceByConfidence()},
  };
}

std::vector<Technique> filterTechniques() {
  return {
      {.name = "cone_mips",
       .about = "one ray; the colour from the mip as large as the surface's cone is at the hit",
       .after_trace = endingWith(coneMips(), composite("reflection_weighed"))},
      {.name = "gloss_blur",
       .about = "one ray; the reflection blurred by the surface's cone, up to edges of depth and normal",
       .after_trace = endingWith(glossBlur(), composite("reflection_blurred_wide"))},
      {.name = "replace_cone_mips",
       .about = "cone_mips in the place of the environment's reflection",
       .frame = "full",
       .after_trace = endingWith(coneMips(), compositeReplace("reflection_weighed"))},
      {.name = "replace_gloss_blur",
       .about = "gloss_blur in the place of the environment's reflection",
       .frame = "full",
       .after_trace = endingWith(glossBlur(), compositeReplace("reflection_blurred_wide"))},
      {.name = "push_pull",
       .about = "holes of the reflection filled from the nearest pixels that are known",
       .after_trace = {resolvePass(),
                       confidencePass(),
                       {.name = "copy_reflection",
                        .outputs = {"known"},
                        .inputs = {{"source", "reflection_weighed"}},
                        .shader = "copy.frag"},
                       {.name = "pull", .outputs = {"known"}, .fills_mips = true},
                       {.name = "push",
                        .outputs = {"reflection_filled"},
                        .inputs = {{"reflection", "reflection_weighed"}},
                        .constants = {{"fill_levels", 5}}},
                       composite("reflection_filled")}},
      {.name = "half_res",
       .about = "one ray for four pixels, brought to full size along surfaces",
       .ray_stride_texels = 2,
       .after_trace = {{.name = "resolve_half",
                        .outputs = {"reflection_half"},
                        .inputs = {{"hit_texel", "hit_texel_half"}, {"ray_work", "ray_work_half"}}},
                       {.name = "upsample", .outputs = {"reflection"}},
                       composite("reflection")}},
  };
}

}  // namespace ssrkit
