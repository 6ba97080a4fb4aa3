#include "frame/image_transfer.h"

#include <algorithm>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <limits>

#include "base/check.h"

namespace ssrkit {

namespace {

bool isHalf(Format format) {
  return format == Format::kRgba16f;
}

void storeTexel(std::byte* to, const std::array<float, 4>& value, std::size_t channel_count, bool half) {
  for (std::size_t channel = 0; channel < channel_count; ++channel) {
    if (half) {
      const std::uint16_t bits = glm::packHalf1x16(value[channel]);
      std::memcpy(to + channel * sizeof(bits), &bits, sizeof(bits));
    } else {
      std::memcpy(to + channel * sizeof(float), &value[channel], sizeof(float));
    }
  }
}

// By the bits of a half. Reading back a table takes a fraction of the time of the conversion.
const std::vector<float>& floatsOfHalves() {
  static const std::vector<float> table = [] {
    std::vector<float> values(std::size_t{std::numeric_limits<std::uint16_t>::max()} + 1);
    for (std::size_t bits = 0; bits < values.size(); ++bits) {
      values[bits] = glm::unpackHalf1x16(static_cast<std::uint16_t>(bits));
    }
    return values;
  }();
  return table;
}

template <class T>
std::span<const T> as(const std::vector<std::byte>& bytes) {
  SSRKIT_CHECK_EQ(bytes.size() % sizeof(T), std::size_t{0});
  return {reinterpret_cast<const T*>(bytes.data()), bytes.size() / sizeof(T)};
}

}  // namespace

Expected<void> uploadImage(Device& device, DeviceImage& to, const Image& from,
                           const std::array<float, 4>& defaults) {
  SSRKIT_CHECK(from.size == to.desc().size);
  const FormatInfo info = formatInfo(to.desc().format);
  const auto channel_count = static_cast<std::size_t>(info.channel_count);
  const std::size_t given = std::min(from.channelCount(), channel_count);
  std::vector<std::byte> bytes(from.texelCount() * info.bytes_per_texel);
  for (std::size_t texel = 0; texel < from.texelCount(); ++texel) {
    std::array<float, 4> value = defaults;
    std::copy_n(from.data.data() + texel * from.channelCount(), given, value.data());
    storeTexel(bytes.data() + texel * info.bytes_per_texel, value, channel_count, isHalf(to.desc().format));
  }
  return device.upload(to, 0, bytes);
}

Expected<void> fillImage(Device& device, DeviceImage& to, const std::array<float, 4>& value) {
  return uploadImage(device, to, Image(to.desc().size, {}), value);
}

Expected<Image> readImage(Device& device, const DeviceImage& from, const std::vector<std::string>& channels) {
  const auto bytes = device.read(from, 0);
  if (!bytes) {
    return tl::make_unexpected(bytes.error());
  }
  const auto stride = static_cast<std::size_t>(formatInfo(from.desc().format).channel_count);
  SSRKIT_CHECK_LE(channels.size(), stride);
  Image image(from.desc().size, channels);
  const auto fill = [&](const auto& texels, const auto& to_float) {
    float* to = image.data.data();
    for (std::size_t texel = 0; texel < image.texelCount(); ++texel) {
      for (std::size_t channel = 0; channel < channels.size(); ++channel) {
        *to++ = to_float(texels[texel * stride + channel]);
      }
    }
  };
  if (isHalf(from.desc().format)) {
    const std::vector<float>& table = floatsOfHalves();
    fill(as<std::uint16_t>(*bytes), [&](std::uint16_t bits) { return table[bits]; });
  } else {
    fill(as<float>(*bytes), [](float value) { return value; });
  }
  return image;
}

Expected<RayRecord> readRecord(Device& device, const DeviceImage& hit_texel, const DeviceImage& hit_point,
                               const DeviceImage& ray_work) {
  const auto texel_bytes = device.read(hit_texel, 0);
  const auto point_bytes = texel_bytes ? device.read(hit_point, 0) : texel_bytes;
  const auto work_bytes = point_bytes ? device.read(ray_work, 0) : point_bytes;
  if (!work_bytes) {
    return tl::make_unexpected(work_bytes.error());
  }
  const auto texels = as<std::int16_t>(*texel_bytes);
  const auto points = as<float>(*point_bytes);
  const auto work = as<std::uint16_t>(*work_bytes);
  RayRecord record{.size = hit_texel.desc().size, .rays = {}};
  record.rays.resize(texels.size() / 2);
  for (std::size_t i = 0; i < record.rays.size(); ++i) {
    // A shader of the user's own may write any number as a class: what is none stays none, for the checks.
    const std::uint16_t ray_class = std::min<std::uint16_t>(work[4 * i], kLastRayClassNumber);
    record.rays[i] = {.texel_x = texels[2 * i],
                      .texel_y = texels[2 * i + 1],
                      .px_x = points[4 * i],
                      .px_y = points[4 * i + 1],
                      .t_m = points[4 * i + 2],
                      .ray_class = static_cast<RayClass>(ray_class),
                      .lookups = work[4 * i + 1],
                      .steps = work[4 * i + 2]};
  }
  return record;
}

}  // namespace ssrkit
