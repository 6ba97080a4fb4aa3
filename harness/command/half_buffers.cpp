#include "command/half_buffers.h"

#include "frame/frame_images.h"

namespace ssrkit {

const std::set<std::string>& halfBuffers() {
  static const std::set<std::string> names = [] {
    std::set<std::string> halves;
    for (const FrameImageRow& image : frameImages()) {
      if (image.format == Format::kRgba16f) {
        halves.insert(image.name);
      }
    }
    return halves;
  }();
  return names;
}

}  // namespace ssrkit
