// One trace over a frame's G-buffer: pyramid, trace, resolve, composite.
#pragma once

#include "base/error.h"
#include "device/device.h"
#include "frame/frame_images.h"
#include "frame/job.h"
#include "frame/programs.h"
#include "frame/pyramid.h"
#include "frame/run_job.h"
#include "frame/stages.h"

namespace ssrkit {

// A full-screen pass of the frame by name ("light", "resolve", "composite") and the images it draws to.
struct FrameStep {
  PassRow row;
  std::vector<std::string> outputs;
};
[[nodiscard]] const FrameStep& lightStep();
[[nodiscard]] FrameStep traceStep(const std::string& shader);

// Draws a step into its images, created when missing.
[[nodiscard]] Expected<PassTime> drawStep(Device& device, const Program& program, const FrameStep& step,
                                          FrameImages& images, const UniformValues& values);

// A trace that is ready to be drawn as often as its timing asks for.
class Tracing {
 public:
  // Finds the stage, fills its defaults, compiles everything that the request needs.
  [[nodiscard]] static Expected<Tracing> prepare(Programs& programs, const CompileSettings& settings,
                                                 const TraceRequest& request, Size size,
                                                 const Progress& progress);

  // Draws pyramid and trace, and, where the request wants colour, resolve and composite. Appends one time a
  // pass: to `cold` the first time, to `steady` afterwards.
  [[nodiscard]] Expected<void> draw(Device& device, FrameImages& images, UniformValues& values,
                                    const Progress& progress);

  // Reads the record and the colour images of the last draw.
  [[nodiscard]] Expected<TraceResult> read(Device& device, const FrameImages& images) const;

 private:
  void addTime(const std::string& pass, const PassTime& time);
  [[nodiscard]] Expected<void> drawColour(Device& device, FrameImages& images, const UniformValues& values);

  std::string stage_;
  TraceParameters parameters_;
  bool want_color_ = true;
  FrameStep trace_step_;
  const Program* trace_ = nullptr;
  const Program* resolve_ = nullptr;
  const Program* composite_ = nullptr;
  PyramidPrograms pyramid_;
  PyramidLayout layout_ = PyramidLayout::kNone;
  bool is_drawn_ = false;
  std::vector<PassReport> reports_;
};

}  // namespace ssrkit
