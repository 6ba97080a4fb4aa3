// G-buffers made by others: camera.json and EXR images in a folder (docs/formats.md).
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "base/error.h"
#include "image/image.h"
#include "spaces/camera.h"

namespace ssrkit {

struct GbufferFiles {
  std::string name;  // the folder's
  Camera camera;
  std::map<std::string, Image> images;  // dist_view and normal_view at least
};

// Reads DIR/camera.json (or the one in the folder above, where `run` puts it) and the images in DIR or
// DIR/gbuffer, with lit.exr in DIR where there is one. Fails on what is missing or of another size than the
// camera's, and on a depth that is NaN, zero or negative, or a normal of no length, at a texel that is not
// background.
[[nodiscard]] Expected<GbufferFiles> readGbuffer(const std::filesystem::path& folder);

}  // namespace ssrkit
