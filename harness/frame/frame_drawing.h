// What all traces of a job share: the G-buffer and the passes of the frame's kind.
#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "device/device.h"
#include "frame/frame_images.h"
#include "frame/frames.h"
#include "frame/pass_times.h"
#include "frame/posed_scene.h"
#include "frame/programs.h"
#include "frame/progress.h"
#include "frame/shadow_map.h"

namespace ssrkit {

class FrameDrawing {
 public:
  // Compiles what is needed. Without a scene the G-buffer's images are there already; so are those of
  // `given_images`: a pass whose first output is among them is left out.
  [[nodiscard]] static Expected<FrameDrawing> prepare(Programs& programs, const CompileSettings& settings,
                                                      const FrameKind& kind, const PosedScene* scene,
                                                      const std::vector<std::string>& given_images,
                                                      const Progress& progress);

  // One round of all passes.
  [[nodiscard]] Expected<void> draw(Device& device, FrameImages& images, const UniformValues& values,
                                    const Progress& progress);

  [[nodiscard]] const std::vector<PreparedPass>& passes() const { return passes_; }
  [[nodiscard]] const std::vector<PassReport>& times() const { return times_.reports(); }

 private:
  // The shadow map, where a pass samples it; without a scene nothing casts a shadow.
  [[nodiscard]] Expected<void> drawShadows(Device& device, FrameImages& images, const UniformValues& values,
                                           const Progress& progress);

  const PosedScene* scene_ = nullptr;  // not owned; posed anew before each frame
  const Program* gbuffer_ = nullptr;
  bool reads_shadow_map_ = false;
  ShadowMapPrograms shadow_map_;
  std::vector<PreparedPass> passes_;
  PassTimes times_;
};

}  // namespace ssrkit
