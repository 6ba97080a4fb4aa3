// A full-screen pass as a row of data: which shader, which images, which constants.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/error.h"
#include "device/device.h"
#include "frame/frame_images.h"
#include "frame/programs.h"
#include "frame/progress.h"
#include "frame/uniform_values.h"

namespace ssrkit {

struct FramePass {
  std::string name;                  // in reports and for --replace
  std::vector<std::string> outputs;  // rows of frame_images.cpp, by the shader's output locations
  std::map<std::string, std::string> inputs = {};  // sampler to image, where it is not the sampler's own name
  // Uniforms and specialisation constants that have these values in this pass only.
  std::map<std::string, UniformConstant> constants = {};
  std::string shader = {};  // entry file; empty: NAME.frag
  // Drawn once for each mip of its only output but the first, with the mip before as the sampler `finer`.
  bool fills_mips = false;
  // Afterwards its outputs and these images, in order and each pair of one kind, change places: so a sum over
  // samples is read under one name and written under the other, draw after draw.
  std::vector<std::string> swaps_with = {};
  // Drawn only where rays start, after the trace, and over its depth (frame/trace_pass.h): elsewhere its
  // outputs keep their clear, or what they hold.
  bool where_rays_start = false;
  // Drawn only where the rasteriser drew a surface: elsewhere its outputs keep their clear. Of a G-buffer
  // made by others nothing was rasterised: it is drawn everywhere.
  bool where_surfaces = false;
  // A row whose depth is tested and written, so that what a pass has covered later ones leave alone: the
  // triangle of layer 1 is nearer than the clear, and nearer by each layer. `where_surfaces`: tested only,
  // from layer 0, the far end.
  std::string depth = {};
  int layer = 0;
  // Of its outputs and its depth: what is cleared to the rows' values before it is drawn.
  std::vector<std::string> clears = {};
  std::map<std::string, std::string> values = {};  // uniforms that have the kit's value of another name
};

// A pass with its program.
struct PreparedPass {
  FramePass pass;
  PassRow row;
  const Program* program = nullptr;
};

[[nodiscard]] PassRow passRow(const FramePass& pass);

// Compiles it. Errors name the author's file and line.
[[nodiscard]] Expected<PreparedPass> preparePass(Programs& programs, const CompileSettings& settings,
                                                 const FramePass& pass, const Progress& progress);
[[nodiscard]] Expected<std::vector<PreparedPass>> preparePasses(Programs& programs,
                                                                const CompileSettings& settings,
                                                                const std::vector<FramePass>& passes,
                                                                const Progress& progress);

// Draws it into its images, created when missing, over the whole of them.
[[nodiscard]] Expected<PassTime> drawPass(Device& device, const PreparedPass& pass, FrameImages& images,
                                          const UniformValues& values);

}  // namespace ssrkit
