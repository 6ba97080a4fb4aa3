// Images of the previous frame, kept for the passes whose samplers name them.
#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "device/device.h"
#include "frame/frame_images.h"
#include "frame/frame_pass.h"

namespace ssrkit {

// A row of frame_images.cpp with `previous_of` is that image as it was one frame earlier. Images that a
// frame's passes make are kept once; those that a technique makes are kept for each trace apart, so that
// traces share no history. Nothing is kept that no pass reads.
class History {
 public:
  // Notes what the passes of the frame, or of a trace (which `owner` tells apart), read.
  void watchFrame(const std::vector<PreparedPass>& passes) { watch(passes, ""); }
  void watchTrace(std::vector<PreparedPass>& passes, const std::string& owner);

  // Before the first frame: every kept image gets its row's clear value, which says that there is no history.
  [[nodiscard]] Expected<void> clear(Device& device, FrameImages& images) const;

  // After a frame's own passes, and after a trace's: keeps the images for the next frame.
  [[nodiscard]] Expected<void> keep(Device& device, FrameImages& images, const std::string& owner) const;

 private:
  struct Kept {
    std::string row;    // "previous_lit"
    std::string image;  // the row's, or one of the owner's own
    std::string owner;  // "" the frame
  };
  void watch(const std::vector<PreparedPass>& passes, const std::string& owner);
  void add(Kept kept);
  std::vector<Kept> kept_;
};

}  // namespace ssrkit
