#include "frame/frame_drawing.h"

#include <algorithm>

#include "frame/gbuffer_source.h"

namespace ssrkit {

Expected<FrameDrawing> FrameDrawing::prepare(Programs& programs, const CompileSettings& settings,
                                             const FrameKind& kind, std::optional<DrawnScene> scene,
                                             const std::vector<std::string>& given_images,
                                             const Progress& progress) {
  FrameDrawing drawing;
  drawing.scene_ = scene;
  if (scene) {
    progress("compile gbuffer");
    const auto program = programs.get(gbufferPass(), settings);
    if (!program) {
      return tl::make_unexpected(program.error());
    }
    drawing.gbuffer_ = *program;
  }
  std::vector<FramePass> passes = kind.passes;
  std::erase_if(passes, [&](const FramePass& pass) {
    return std::ranges::find(given_images, pass.outputs.front()) != given_images.end();
  });
  auto prepared = preparePasses(programs, settings, passes, progress);
  if (!prepared) {
    return tl::make_unexpected(prepared.error());
  }
  drawing.passes_ = std::move(*prepared);
  return drawing;
}

Expected<void> FrameDrawing::draw(Device& device, FrameImages& images, const UniformValues& values,
                                  const Progress& progress) {
  if (scene_) {
    progress("draw gbuffer");
    const auto time = drawGbuffer(device, *gbuffer_, *scene_->scene, *scene_->resources, images, values);
    if (!time) {
      return tl::make_unexpected(time.error());
    }
    times_.add("gbuffer", *time);
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

}  // namespace ssrkit
