#include "frame/environment_images.h"

#include <span>

#include "environment/split_sum.h"

namespace ssrkit {

namespace {

Expected<void> uploadMap(Device& device, FrameImages& images, const std::string& name,
                         std::span<const HalfMap> mips) {
  const int side = mips.front().side;
  const auto image = images.getSized({.name = name,
                                      .format = frameImageRow(name).format,
                                      .size = {side, side},
                                      .mip_count = static_cast<int>(mips.size())});
  if (!image) {
    return tl::make_unexpected(image.error());
  }
  for (std::size_t mip = 0; mip < mips.size(); ++mip) {
    const auto bytes = std::as_bytes(std::span(mips[mip].rgba));
    if (const auto done = device.upload(**image, static_cast<int>(mip), bytes); !done) {
      return done;
    }
  }
  return {};
}

}  // namespace

EnvironmentSource environmentSource(const Scene& scene, const std::optional<EnvironmentChoice>& chosen) {
  const EnvironmentChoice choice = chosen.value_or(scene.environment);
  return {.file = choice.file,
          .horizon = choice.constant.value_or(scene.sky_horizon),
          .zenith = scene.sky_zenith,
          .is_constant = choice.constant.has_value()};
}

Expected<void> uploadEnvironment(Device& device, const EnvironmentMaps& maps, FrameImages& images,
                                 UniformValues& values) {
  values.set("environment_side", static_cast<double>(maps.mips.front().side));
  values.set("environment_mip_count", static_cast<double>(maps.mips.size()));
  values.set("irradiance_side", static_cast<double>(maps.irradiance.side));
  values.set("split_sum_side", static_cast<double>(kSplitSumSide));
  auto done = uploadMap(device, images, "environment", maps.mips);
  done = done ? uploadMap(device, images, "irradiance", {&maps.irradiance, 1}) : done;
  if (!done) {
    return done;
  }
  const auto table = images.getSized({.name = "split_sum",
                                      .format = frameImageRow("split_sum").format,
                                      .size = {kSplitSumSide, kSplitSumSide},
                                      .mip_count = 1});
  return table ? device.upload(**table, 0, std::as_bytes(std::span(maps.split_sum)))
               : tl::make_unexpected(table.error());
}

}  // namespace ssrkit
