#include "image/png.h"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/atomic_file.h"
#include "base/check.h"
#include "image/codec.h"

namespace ssrkit {

Expected<void> writePng(const std::filesystem::path& path, const ByteImage& image) {
  SSRKIT_CHECK(image.channel_count == 3 || image.channel_count == 4);
  SSRKIT_CHECK_EQ(image.data.size(), image.texelCount() * static_cast<std::size_t>(image.channel_count));
  const auto codec = imageCodec();
  if (!codec) {
    return tl::make_unexpected(codec.error());
  }
  std::vector<unsigned char> bytes;
  if (std::string problem = (*codec)->encodePng(image, bytes); !problem.empty()) {
    return setupError(fmt::format("encode '{}' as PNG", path.string()), std::move(problem));
  }
  return writeFileAtomically(path,
                             std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

}  // namespace ssrkit
