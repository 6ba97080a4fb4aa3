#include "frame/frame_pass.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/check.h"
#include "device/format.h"
#include "device/pass_clock.h"
#include "frame/blue_noise.h"

namespace ssrkit {

namespace {

using Aliases = std::map<std::string, SampledImage>;

// The images that a pass names for its samplers.
Expected<Aliases> aliasesOf(const PreparedPass& pass, const FrameImages& images) {
  Aliases aliases;
  for (const auto& [sampler, name] : pass.pass.inputs) {
    const SampledImage sampled = images.sampled(name);
    if (sampled.image == nullptr) {
      return inputError(fmt::format("draw the pass '{}'", pass.pass.name),
                        fmt::format("the image '{}' has not been made", name), pass.program->shader,
                        "an earlier pass of the frame or of the technique must write it");
    }
    aliases.emplace(sampler, sampled);
  }
  return aliases;
}

// The mask of blue noise is made for the first pass that reads it.
Expected<void> makeBlueNoise(Device& device, const PreparedPass& pass, FrameImages& images) {
  const bool is_read = std::ranges::any_of(
      pass.program->samplers, [](const SamplerBinding& sampler) { return sampler.name == "blue_noise"; });
  return is_read && images.find("blue_noise") == nullptr ? uploadBlueNoise(device, images) : Expected<void>{};
}

// Before its first draw the images that it swaps with are there, with whatever in it: the shader knows that
// it is first.
Expected<void> makePartners(const FramePass& pass, FrameImages& images) {
  SSRKIT_CHECK_LE(pass.swaps_with.size(), pass.outputs.size());
  for (std::size_t i = 0; i < pass.swaps_with.size(); ++i) {
    SSRKIT_CHECK(frameImageRow(pass.swaps_with[i]).format == frameImageRow(pass.outputs[i]).format);
    if (const auto image = images.get(pass.swaps_with[i]); !image) {
      return tl::make_unexpected(image.error());
    }
  }
  return {};
}

// An output or the depth, created when missing.
Expected<Attachment> attachmentOf(const FramePass& pass, const std::string& name, FrameImages& images) {
  const auto image = images.get(name);
  if (!image) {
    return tl::make_unexpected(image.error());
  }
  Attachment attachment{*image, 0, std::nullopt};
  if (std::ranges::find(pass.clears, name) != pass.clears.end()) {
    attachment.clear = frameImageRow(name).clear;
  }
  return attachment;
}

struct Targets {
  std::vector<Attachment> colour;
  std::optional<Attachment> depth;
};

Expected<Targets> targetsOf(const FramePass& pass, FrameImages& images) {
  Targets targets;
  for (const std::string& output : pass.outputs) {
    const auto colour = attachmentOf(pass, output, images);
    if (!colour) {
      return tl::make_unexpected(colour.error());
    }
    targets.colour.push_back(*colour);
  }
  if (!pass.depth.empty()) {
    const auto depth = attachmentOf(pass, pass.depth, images);
    if (!depth) {
      return tl::make_unexpected(depth.error());
    }
    targets.depth = *depth;
  }
  return targets;
}

Expected<UniformValues> valuesOf(const FramePass& pass, const UniformValues& shared) {
  UniformValues values = shared;
  for (const auto& [name, existing] : pass.values) {
    if (const auto given = values.alias(name, shared, existing); !given) {
      return tl::make_unexpected(given.error());
    }
  }
  for (const auto& [name, constant] : pass.constants) {
    std::visit([&values, &uniform = name](auto value) { values.set(uniform, value); }, constant);
  }
  return values;
}

Expected<PassTime> drawMips(Device& device, const PreparedPass& pass, DeviceImage& image,
                            const Aliases& aliases, const FrameImages& images, const UniformValues& values) {
  PassTime sum{.wall_ns = 0, .cpu_ns = 0, .device_ns = 0};
  for (int mip = 1; mip < image.desc().mip_count; ++mip) {
    Aliases with_finer = aliases;
    with_finer["finer"] = {.image = &image, .base_mip = mip - 1};
    const Size size = mipSize(image.desc(), mip);
    const auto time = drawFullScreen(device, *pass.program,
                                     {.row = &pass.row,
                                      .targets = {{&image, mip, std::nullopt}},
                                      .viewport = {0, 0, size.width, size.height},
                                      .aliases = with_finer},
                                     images, values);
    if (!time) {
      return time;
    }
    sum += *time;
  }
  return sum;
}

DepthTest depthTestOf(const FramePass& pass) {
  if (pass.depth.empty()) {
    return DepthTest::kNone;
  }
  return pass.where_surfaces ? DepthTest::kBehind : DepthTest::kNearer;
}

}  // namespace

PassRow passRow(const FramePass& pass) {
  PassRow row{.name = pass.name,
              .vertex_shader = "full_screen.vert",
              .fragment_shader = pass.shader.empty() ? pass.name + ".frag" : pass.shader,
              .colour_formats = {},
              .depth_test = depthTestOf(pass),
              .vertex_attributes = {},
              .vertex_stride_bytes = 0,
              .constants = pass.constants};
  for (const std::string& output : pass.outputs) {
    row.colour_formats.push_back(frameImageRow(output).format);
  }
  return row;
}

Expected<PreparedPass> preparePass(Programs& programs, const CompileSettings& settings, const FramePass& pass,
                                   const Progress& progress) {
  PreparedPass prepared{.pass = pass, .row = passRow(pass)};
  progress("compile " + pass.name);
  const auto program = programs.get(prepared.row, settings);
  if (!program) {
    return tl::make_unexpected(program.error());
  }
  prepared.program = *program;
  return prepared;
}

Expected<std::vector<PreparedPass>> preparePasses(Programs& programs, const CompileSettings& settings,
                                                  const std::vector<FramePass>& passes,
                                                  const Progress& progress) {
  std::vector<PreparedPass> prepared;
  for (const FramePass& pass : passes) {
    auto one = preparePass(programs, settings, pass, progress);
    if (!one) {
      return tl::make_unexpected(one.error());
    }
    prepared.push_back(std::move(*one));
  }
  return prepared;
}

Expected<PassTime> drawPass(Device& device, const PreparedPass& pass, FrameImages& images,
                            const UniformValues& values) {
  SSRKIT_CHECK(!pass.pass.outputs.empty());
  const auto aliases = aliasesOf(pass, images);
  if (!aliases) {
    return tl::make_unexpected(aliases.error());
  }
  const auto targets = targetsOf(pass.pass, images);
  if (!targets) {
    return tl::make_unexpected(targets.error());
  }
  auto made = makePartners(pass.pass, images);
  made = made ? makeBlueNoise(device, pass, images) : made;
  if (!made) {
    return tl::make_unexpected(made.error());
  }
  const auto own_values = valuesOf(pass.pass, values);
  if (!own_values) {
    return tl::make_unexpected(own_values.error());
  }
  if (pass.pass.fills_mips) {
    return drawMips(device, pass, *targets->colour.front().image, *aliases, images, *own_values);
  }
  const Size size = targets->colour.front().image->desc().size;
  auto time = drawFullScreen(device, *pass.program,
                             {.row = &pass.row,
                              .targets = targets->colour,
                              .depth = targets->depth,
                              .viewport = {0, 0, size.width, size.height},
                              .aliases = *aliases,
                              .layer = pass.pass.layer},
                             images, *own_values);
  for (std::size_t i = 0; time && i < pass.pass.swaps_with.size(); ++i) {
    images.swap(pass.pass.outputs[i], pass.pass.swaps_with[i]);
  }
  return time;
}

}  // namespace ssrkit
