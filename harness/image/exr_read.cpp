#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "base/atomic_file.h"
#include "base/text.h"
#include "image/codec.h"
#include "image/exr.h"
#include "image/exr_header.h"

namespace ssrkit {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMaxFileBytes = std::size_t{1} << 30;

tl::unexpected<Error> readError(const fs::path& path, std::string problem, std::string remedy) {
  return inputError(fmt::format("read '{}'", path.string()), std::move(problem), {}, std::move(remedy));
}

Expected<ExrHeader> acceptedHeader(const fs::path& path, std::string_view file,
                                   const ExrExpectation& expected) {
  ExrHeader header;
  std::string problem;
  if (!readExrHeader(file, header, problem)) {
    return readError(path, problem, "write it as a flat, single-part EXR");
  }
  if (header.is_crop || header.has_subsampled_channel) {
    return readError(path,
                     header.is_crop ? "its data window is not the whole image (a crop or overscan)"
                                    : "a channel has fewer samples than the image has texels",
                     "write every channel for exactly the texels of the image");
  }
  if (expected.size && *expected.size != header.size) {
    return readError(path,
                     fmt::format("it is {} x {} texels, and {} x {} are expected", header.size.width,
                                 header.size.height, expected.size->width, expected.size->height),
                     "write all images of one view in one size");
  }
  return header;
}

bool contains(std::span<const std::string> names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

Expected<std::vector<std::string>> wantedChannels(const fs::path& path, const ExrHeader& header,
                                                  const ExrExpectation& expected) {
  const std::vector<std::string>& wanted = expected.channels.empty() ? header.channels : expected.channels;
  for (const std::string& channel : wanted) {
    if (!contains(header.channels, channel)) {
      constexpr std::size_t kListed = 32;
      const std::span<const std::string> listed(header.channels.data(),
                                                std::min(header.channels.size(), kListed));
      return readError(path,
                       fmt::format("the channel '{}' is missing; it holds {}{}", channel, joinNames(listed),
                                   listed.size() < header.channels.size() ? " and more" : ""),
                       fmt::format("write the channels {}", joinNames(wanted)));
    }
    if (contains(header.integer_channels, channel)) {
      return readError(path, fmt::format("the channel '{}' holds integers", channel),
                       "write it as 32-bit float, which is exact up to 16,777,216");
    }
  }
  const long long bytes = static_cast<long long>(header.size.width) * header.size.height *
                          static_cast<long long>(header.channels.size() * sizeof(float));
  if (bytes > kMaxImageBytes) {
    return readError(path,
                     fmt::format("it holds {} bytes, and the kit reads up to {}", bytes, kMaxImageBytes),
                     "write a smaller image");
  }
  return wanted;
}

}  // namespace

Expected<Image> readExr(const fs::path& path, const ExrExpectation& expected) {
  const Expected<std::string> file = readFile(path, kMaxFileBytes);
  if (!file) {
    return tl::make_unexpected(file.error());
  }
  const Expected<ExrHeader> header = acceptedHeader(path, *file, expected);
  if (!header) {
    return tl::make_unexpected(header.error());
  }
  const Expected<std::vector<std::string>> wanted = wantedChannels(path, *header, expected);
  if (!wanted) {
    return tl::make_unexpected(wanted.error());
  }
  const auto codec = imageCodec();
  if (!codec) {
    return tl::make_unexpected(codec.error());
  }
  Image image(header->size, *wanted);
  if (std::string problem = (*codec)->decodeExr(*file, image); !problem.empty()) {
    return readError(path, std::move(problem), "write the file again");
  }
  return image;
}

}  // namespace ssrkit
