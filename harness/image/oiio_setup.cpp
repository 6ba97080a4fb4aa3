#include "image/oiio_setup.h"

#include <OpenImageIO/imageio.h>

namespace ssrkit {

void setUpOiio() {
  static const bool done = [] {
    constexpr int kMebibyte = 1 << 20;
    OIIO::attribute("threads", 1);
    OIIO::attribute("exr_threads", -1);  // -1: no thread pool of OpenEXR's own
    OIIO::attribute("limits:channels", kMaxImageChannels);
    OIIO::attribute("limits:imagesize_MB", static_cast<int>(kMaxImageBytes / kMebibyte));
    return true;
  }();
  static_cast<void>(done);
}

}  // namespace ssrkit
