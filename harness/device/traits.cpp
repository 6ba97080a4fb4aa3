#include "device/traits.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "shader/interface.h"

namespace ssrkit {
namespace {

constexpr std::uint32_t kFullCount = 512;  // 512 * 512 turns: four times Mesa's cap
constexpr double kTimerSlack = 0.2;
constexpr std::int64_t kLoadNs = 8'000'000;  // long enough that tiles, threads and the clock's own cost fade
constexpr Size kLoadSize{128, 128};
constexpr std::uint32_t kMostLoadCount = 60'000;  // below Mesa's cap, or more turns would cost nothing

struct Counts {  // the block of probe/count.frag
  std::uint32_t outer_count = 0;
  std::uint32_t inner_count = 0;
  std::array<std::uint32_t, 2> padding{};
};

struct Probe {
  Device& device;
  std::unique_ptr<DeviceProgram> program;
  std::unique_ptr<DeviceImage> target;
};

Expected<Probe> createProbe(Device& device, ShaderTarget target, const std::filesystem::path& shader_root) {
  const Expected<ShaderModule> vertex = compileShader(
      {.root = shader_root, .entry = "full_screen.vert", .stage = ShaderStage::kVertex, .defines = {}},
      target);
  if (!vertex) {
    return tl::unexpected(vertex.error());
  }
  const Expected<ShaderModule> fragment = compileShader(
      {.root = shader_root, .entry = "probe/count.frag", .stage = ShaderStage::kFragment, .defines = {}},
      target);
  if (!fragment) {
    return tl::unexpected(fragment.error());
  }
  ProgramDesc desc;
  desc.name = "probe";
  desc.vertex_spirv = vertex->spirv;
  desc.fragment_spirv = fragment->spirv;
  for (const UniformBlock& block : fragment->interface.uniform_blocks) {
    desc.uniform_bindings.push_back(block.binding);
  }
  desc.colour_formats = {Format::kRg32f};
  auto program = device.createProgram(desc);
  if (!program) {
    return tl::unexpected(program.error());
  }
  auto image =
      device.createImage({.name = "probe", .format = Format::kRg32f, .size = kLoadSize, .mip_count = 1});
  if (!image) {
    return tl::unexpected(image.error());
  }
  return Probe{device, std::move(*program), std::move(*image)};
}

Expected<PassTime> drawCounts(const Probe& probe, Counts counts, Size size) {
  PassDesc pass;
  pass.name = "probe";
  pass.program = probe.program.get();
  pass.uniforms = std::as_bytes(std::span(&counts, 1));
  pass.colour = {{.image = probe.target.get(), .mip = 0, .clear = {}}};
  pass.viewport = {.x = 0, .y = 0, .width = size.width, .height = size.height};
  return probe.device.draw(pass);
}

// How far one texel counted.
Expected<std::uint32_t> findLoopCap(const Probe& probe) {
  const Expected<PassTime> drawn =
      drawCounts(probe, {.outer_count = kFullCount, .inner_count = kFullCount}, {1, 1});
  if (!drawn) {
    return tl::unexpected(drawn.error());
  }
  const Expected<std::vector<std::byte>> bytes = probe.device.read(*probe.target, 0);
  if (!bytes) {
    return tl::unexpected(bytes.error());
  }
  float reached = 0.0F;
  std::memcpy(&reached, bytes->data(), sizeof(reached));
  const auto count = static_cast<std::uint32_t>(reached);
  return count == kFullCount * kFullCount ? 0U : count;
}

bool agrees(const PassTime& time) {
  return time.device_ns && std::abs(static_cast<double>(*time.device_ns - time.wall_ns)) <=
                               kTimerSlack * static_cast<double>(time.wall_ns);
}

Expected<PassTime> drawLoad(const Probe& probe, std::uint32_t count) {
  return drawCounts(probe, {.outer_count = 1, .inner_count = count}, kLoadSize);
}

// Turns a texel that last long enough for the clocks to be compared.
Expected<std::uint32_t> findLoad(const Probe& probe) {
  std::uint32_t count = 4;  // 8 ms already where shaders are interpreted
  while (count < kMostLoadCount) {
    const Expected<PassTime> time = drawLoad(probe, count);
    if (!time) {
      return tl::unexpected(time.error());
    }
    if (time->wall_ns >= kLoadNs / 2) {
      break;
    }
    const std::int64_t factor =
        std::clamp<std::int64_t>(kLoadNs / std::max<std::int64_t>(time->wall_ns, 1), 2, 64);
    count = static_cast<std::uint32_t>(std::min<std::int64_t>(count * factor, kMostLoadCount));
  }
  return count;
}

// Twice right of five: once may be chance, and on a busy machine a good timer may disagree now and then. It
// is paid for at every start of a worker, so no more is drawn than settles it.
Expected<bool> isTimerUsable(const Probe& probe) {
  const Expected<std::uint32_t> count = findLoad(probe);
  if (!count) {
    return tl::unexpected(count.error());
  }
  constexpr int kEnough = 2;
  int agreed = 0;
  for (int left = 5; agreed < kEnough && agreed + left >= kEnough; --left) {
    const Expected<PassTime> time = drawLoad(probe, *count);
    if (!time) {
      return tl::unexpected(time.error());
    }
    if (!time->device_ns) {
      return false;
    }
    agreed += agrees(*time) ? 1 : 0;
  }
  return agreed == kEnough;
}

}  // namespace

Expected<DeviceTraits> probeTraits(Device& device, ShaderTarget target,
                                   const std::filesystem::path& shader_root) {
  const Expected<Probe> probe = createProbe(device, target, shader_root);
  if (!probe) {
    return tl::unexpected(probe.error());
  }
  const Expected<std::uint32_t> loop_cap = findLoopCap(*probe);
  if (!loop_cap) {
    return tl::unexpected(loop_cap.error());
  }
  const Expected<bool> timer_usable = isTimerUsable(*probe);
  if (!timer_usable) {
    return tl::unexpected(timer_usable.error());
  }
  return DeviceTraits{
      .loop_cap = *loop_cap, .device_timer_usable = *timer_usable, .shader_input = device.shaderInput()};
}

}  // namespace ssrkit
