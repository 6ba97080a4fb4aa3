// One trace over a frame, with the technique that makes a picture of it.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/error.h"
#include "device/device.h"
#include "frame/frame_images.h"
#include "frame/frame_pass.h"
#include "frame/history.h"
#include "frame/job.h"
#include "frame/pass_times.h"
#include "frame/programs.h"
#include "frame/progress.h"
#include "frame/pyramid.h"
#include "frame/stages.h"
#include "frame/techniques.h"

namespace ssrkit {

// A trace that is ready to be drawn as often as its timing asks for.
class Tracing {
 public:
  // Finds the stage and the technique, fills their defaults, compiles everything that one of the job's
  // requests needs.
  [[nodiscard]] static Expected<Tracing> prepare(Programs& programs, const CompileSettings& settings,
                                                 const Job& job, const TraceRequest& request,
                                                 const Progress& progress);

  // Has the history keep what the technique reads of the previous frame; `owner` tells traces apart.
  void watchHistory(History& history, const std::string& owner);

  // One round: pyramid, then for each sample the trace and what the technique does around it.
  [[nodiscard]] Expected<void> draw(Device& device, FrameImages& images, UniformValues& values,
                                    const Progress& progress);

  // Reads the record (of the last sample) and the technique's images of the last draw.
  [[nodiscard]] Expected<TraceResult> read(Device& device, const FrameImages& images) const;

  // The images that read() reads beside those that leave the device with the frame.
  [[nodiscard]] std::set<std::string> imagesToRead() const;

 private:
  [[nodiscard]] Expected<void> drawAll(Device& device, const std::vector<PreparedPass>& passes,
                                       FrameImages& images, const UniformValues& values,
                                       const Progress& progress);
  [[nodiscard]] Expected<void> drawTrace(Device& device, FrameImages& images, const UniformValues& values,
                                         const Progress& progress);

  // The device images that become pictures of the result, by their names there.
  [[nodiscard]] std::map<std::string, std::string> pictures() const;

  // What the pyramid is built from: the image that the tracer reads as dist_view.
  [[nodiscard]] std::string depthImage() const;

  std::string stage_;
  TraceParameters parameters_;
  Technique technique_;              // an empty one when no picture is wanted
  std::vector<PreparedPass> trace_;  // the tracer's own is the last
  std::vector<PreparedPass> before_pyramid_;
  std::vector<PreparedPass> before_trace_;
  std::vector<PreparedPass> after_sample_;
  std::vector<PreparedPass> after_trace_;
  PyramidPrograms pyramid_;
  PyramidLayout layout_ = PyramidLayout::kNone;
  PassTimes times_;
};

}  // namespace ssrkit
