#include "frame/frame_drawing.h"

#include <algorithm>

#include "frame/gbuffer_source.h"
#include "frame/given_gbuffer.h"
#include "frame/shadow_map.h"

namespace ssrkit {

namespace {

bool readsShadowMap(const PreparedPass& pass) {
  return std::ranges::any_of(pass.program->samplers,
                             [](const SamplerBinding& sampler) { return sampler.name == "shadow_map"; });
}

// The kind's, with what this scene makes of them and without those whose image was given.
std::vector<FramePass> passesOf(const FrameKind& kind, const PosedScene* scene,
                                const std::vector<std::string>& given_images) {
  std::vector<FramePass> passes = kind.passes;
  std::erase_if(passes, [&](const FramePass& pass) {
    return std::ranges::find(given_images, pass.outputs.front()) != given_images.end();
  });
  const auto lights = lightConstants(scene != nullptr ? scene->scene : sceneOfGiven());
  for (FramePass& pass : passes) {
    pass.constants.insert(lights.begin(), lights.end());
    if (pass.where_surfaces && scene != nullptr) {
      pass.depth = "depth_window";
    }
  }
  return passes;
}

}  // namespace

Expected<FrameDrawing> FrameDrawing::prepare(Programs& programs, const CompileSettings& settings,
                                             const FrameKind& kind, const PosedScene* scene,
                                             const std::vector<std::string>& given_images,
                                             const Progress& progress) {
  FrameDrawing drawing;
  drawing.scene_ = scene;
  if (scene != nullptr) {
    progress("compile gbuffer");
    const auto program = programs.get(gbufferPassFor(settings, scene->scene), settings);
    if (!program) {
      return tl::make_unexpected(program.error());
    }
    drawing.gbuffer_ = *program;
  }
  auto prepared = preparePasses(programs, settings, passesOf(kind, scene, given_images), progress);
  if (!prepared) {
    return tl::make_unexpected(prepared.error());
  }
  drawing.passes_ = std::move(*prepared);
  drawing.reads_shadow_map_ = std::ranges::any_of(drawing.passes_, readsShadowMap);
  if (scene != nullptr && drawing.reads_shadow_map_) {
    progress("compile shadow_map");
    const auto compiled = shadowMapPrograms(programs, settings);
    if (!compiled) {
      return tl::make_unexpected(compiled.error());
    }
    drawing.shadow_map_ = *compiled;
  }
  return drawing;
}

Expected<void> FrameDrawing::draw(Device& device, FrameImages& images, const UniformValues& values,
                                  const Progress& progress) {
  if (scene_ != nullptr) {
    progress("draw gbuffer");
    const auto time = drawGbuffer(device, *gbuffer_, scene_->scene, scene_->resources, images, values);
    if (!time) {
      return tl::make_unexpected(time.error());
    }
    times_.add("gbuffer", *time);
  }
  if (const auto drawn = drawShadows(device, images, values, progress); !drawn) {
    return drawn;
  }
  for (const PreparedPass& pass : passes_) {
    progress("draw " + pass.pass.name);
    const auto time = drawPass(device, pass, images, values);
    if (!time) {
      return tl::make_unexpected(time.error());
    }
    times_.add(pass.pass.name, *time);
  }
  times_.endRound();
  return {};
}

Expected<void> FrameDrawing::drawShadows(Device& device, FrameImages& images, const UniformValues& values,
                                         const Progress& progress) {
  if (!reads_shadow_map_) {
    return {};
  }
  if (scene_ == nullptr) {
    return clearShadowMap(device, images);
  }
  progress("draw shadow_map");
  const auto time = drawShadowMap(device, shadow_map_, scene_->shadow_cascade_count, scene_->scene,
                                  scene_->resources, images, values);
  if (!time) {
    return tl::make_unexpected(time.error());
  }
  times_.add("shadow_map", *time);
  return {};
}

}  // namespace ssrkit
