#include "environment/equirect.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/atomic_file.h"
#include "environment/pi.h"
#include "image/exr.h"
#include "image/exr_header.h"

namespace ssrkit {

namespace {

constexpr float kLargestHalf = 65504.0F;

tl::unexpected<Error> refuse(const std::filesystem::path& file, std::string problem, std::string remedy) {
  return inputError("read the environment", std::move(problem), file.string(), std::move(remedy));
}

Expected<void> checkShape(const std::filesystem::path& file, Size size) {
  if (size.width != 2 * size.height) {
    return refuse(file,
                  fmt::format("it is {} x {} texels, not twice as wide as high", size.width, size.height),
                  "give an equirectangular map of the whole sphere");
  }
  if (size.width > kMaxEquirectWidth) {
    return refuse(
        file, fmt::format("it is {} texels wide, and the kit reads up to {}", size.width, kMaxEquirectWidth),
        "write a smaller map");
  }
  return {};
}

Expected<void> checkTexels(const std::filesystem::path& file, const Image& image) {
  const auto bad =
      std::ranges::find_if(image.data, [](float value) { return !(value >= 0.0F && value <= kLargestHalf); });
  if (bad == image.data.end()) {
    return {};
  }
  const auto texel = (bad - image.data.begin()) / 3;
  const std::string problem = fmt::format(
      "{} at texel ({}, {}) is {}", image.channels[static_cast<std::size_t>((bad - image.data.begin()) % 3)],
      texel % image.size.width, texel / image.size.width, *bad);
  return *bad > kLargestHalf && std::isfinite(*bad)
             ? refuse(file, problem + ", and the frame's images hold radiance up to 65504",
                      "scale the whole map down, and the lights with it")
             : refuse(file, problem, "radiance must be finite and not negative");
}

}  // namespace

Expected<Image> readEquirect(const std::filesystem::path& file) {
  const auto bytes = readFile(file, kMaxEquirectBytes);
  if (!bytes) {
    return refuse(file, bytes.error().problem, bytes.error().remedy);
  }
  ExrHeader header;
  std::string problem;
  if (readExrHeader(*bytes, header, problem)) {
    if (const auto shape = checkShape(file, header.size); !shape) {
      return tl::make_unexpected(shape.error());
    }
  }
  auto image = readExr(file, {.channels = {"R", "G", "B"}, .size = std::nullopt});
  if (!image) {
    return refuse(file, image.error().problem, image.error().remedy);
  }
  if (const auto texels = checkTexels(file, *image); !texels) {
    return tl::make_unexpected(texels.error());
  }
  return image;
}

glm::vec2 equirectFromDirection(glm::vec3 direction, Size size) {
  const float turn = std::atan2(direction.x, -direction.z) / (2.0F * kPi) + 0.5F;
  const float fall = std::acos(std::clamp(direction.y, -1.0F, 1.0F)) / kPi;
  return {turn * static_cast<float>(size.width), fall * static_cast<float>(size.height)};
}

glm::vec3 sampleEquirect(const Image& image, glm::vec3 direction) {
  const glm::vec2 position = equirectFromDirection(direction, image.size) - 0.5F;
  const glm::vec2 cell = glm::floor(position);
  const glm::vec2 weight = position - cell;
  const auto texel = [&](int x, int y) {
    const int column = (x + image.size.width) % image.size.width;
    const std::size_t at = image.index(column, std::clamp(y, 0, image.size.height - 1));
    return glm::vec3(image.data[at], image.data[at + 1], image.data[at + 2]);
  };
  const int x = static_cast<int>(cell.x);
  const int y = static_cast<int>(cell.y);
  return glm::mix(glm::mix(texel(x, y), texel(x + 1, y), weight.x),
                  glm::mix(texel(x, y + 1), texel(x + 1, y + 1), weight.x), weight.y);
}

}  // namespace ssrkit
