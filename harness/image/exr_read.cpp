#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <span>
#include <utility>

#include "base/atomic_file.h"
#include "base/text.h"
#include "image/exr.h"
#include "image/exr_header.h"
#include "image/oiio_setup.h"

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

// For each wanted channel its number in the file.
Expected<std::vector<std::size_t>> channelNumbers(const fs::path& path, const OIIO::ImageSpec& spec,
                                                  const ExrHeader& header,
                                                  const std::vector<std::string>& wanted) {
  std::vector<std::size_t> numbers;
  for (const std::string& channel : wanted) {
    const auto found = std::ranges::find(spec.channelnames, channel);
    numbers.push_back(static_cast<std::size_t>(found - spec.channelnames.begin()));
  }
  const bool all_found = std::ranges::max(numbers) < spec.channelnames.size();
  if (!all_found || spec.width != header.size.width || spec.height != header.size.height || spec.deep) {
    return readError(path, "its header contradicts itself", "write the file again");
  }
  return numbers;
}

// Reads the smallest range that holds the wanted channels in one go (each call would decompress the whole
// file again) and puts them in the wanted order.
Expected<Image> readChannels(const fs::path& path, const std::string& file, const ExrHeader& header,
                             const std::vector<std::string>& wanted) {
  OIIO::Filesystem::IOMemReader memory(const_cast<char*>(file.data()),
                                       file.size());  // OIIO 2.4 takes no const
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create("exr", false, nullptr, &memory);
  OIIO::ImageSpec spec;
  if (!input || !input->set_ioproxy(&memory) || !input->open(path.string(), spec)) {
    return readError(path, "it is damaged: " + (input ? input->geterror() : OIIO::geterror()),
                     "write the file again");
  }
  const Expected<std::vector<std::size_t>> numbers = channelNumbers(path, spec, header, wanted);
  if (!numbers) {
    return tl::make_unexpected(numbers.error());
  }
  const auto [first, last] = std::ranges::minmax(*numbers);
  const std::size_t range = last - first + 1;
  Image image(header.size, wanted);
  std::vector<float> texels(image.texelCount() * range);
  if (!input->read_image(0, 0, static_cast<int>(first), static_cast<int>(last) + 1, OIIO::TypeDesc::FLOAT,
                         texels.data())) {
    return readError(path, "it is damaged: " + input->geterror(), "write the file again");
  }
  for (std::size_t texel = 0; texel < image.texelCount(); ++texel) {
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      image.data[texel * wanted.size() + i] = texels[texel * range + (*numbers)[i] - first];
    }
  }
  return image;
}

}  // namespace

Expected<Image> readExr(const fs::path& path, const ExrExpectation& expected) {
  setUpOiio();
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
  return readChannels(path, *file, *header, *wanted);
}

}  // namespace ssrkit
