#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/check.h"
#include "image/codec.h"
#include "image/exr.h"

namespace ssrkit {

Expected<void> writeExr(const std::filesystem::path& path, const Image& image, const ExrMetadata& metadata) {
  SSRKIT_CHECK_EQ(image.data.size(), image.texelCount() * image.channelCount());
  SSRKIT_CHECK_LT(std::size_t{0}, image.data.size());
  const auto codec = imageCodec();
  if (!codec) {
    return tl::make_unexpected(codec.error());
  }
  std::vector<unsigned char> bytes;
  if (std::string problem = (*codec)->encodeExr(image, metadata, bytes); !problem.empty()) {
    return setupError(fmt::format("encode '{}' as EXR", path.string()), std::move(problem));
  }
  return writeFileAtomically(path,
                             std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

}  // namespace ssrkit
