// The techniques, as rows of data: what is done before and after a trace to make a picture of it.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "frame/frame_pass.h"

namespace ssrkit {

struct Technique {
  std::string name;
  std::string about;                           // one line for people
  std::string frame;                           // the kind of frame whose images it reads; empty: any
  std::vector<FramePass> before_pyramid = {};  // once, before the pyramid is built
  std::vector<FramePass> before_trace = {};    // before each sample's trace
  std::map<std::string, std::string> trace_inputs = {};  // the tracer's samplers to images of its own
  // Rays start from the upper left texel of each block of this side; over 1 the trace writes hit_texel_half,
  // hit_point_half and ray_work_half.
  int ray_stride_texels = 1;
  // The trace is repeated this often; `sample_index` counts up to `sample_count` in the uniforms.
  int sample_count = 1;
  std::vector<FramePass> after_sample = {};  // after each sample's trace
  std::vector<FramePass> after_trace = {};   // once, at the end
  // How many frames it wants unless told otherwise: what reads the previous frame shows nothing in the first.
  int frame_count = 1;
  std::vector<std::string> read_back = {"reflection", "composite"};
};

[[nodiscard]] std::span<const Technique> techniques();

// Fails with the nearest name and the list.
[[nodiscard]] Expected<const Technique*> findTechnique(std::string_view name);

}  // namespace ssrkit
