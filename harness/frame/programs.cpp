#include "frame/programs.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <variant>

#include "base/text.h"
#include "device/pass_clock.h"

namespace ssrkit {

namespace {

std::vector<std::uint32_t> constantIds(const ShaderInterface& interface) {
  std::vector<std::uint32_t> ids;
  for (const SpecConstantInfo& constant : interface.spec_constants) {
    ids.push_back(constant.id);
  }
  return ids;
}

// The bits of a constant as the shader declares it.
std::uint32_t bitsOf(const UniformConstant& value, ScalarType type) {
  const double number = std::visit([](auto given) { return static_cast<double>(given); }, value);
  return type == ScalarType::kFloat ? std::bit_cast<std::uint32_t>(static_cast<float>(number))
                                    : static_cast<std::uint32_t>(static_cast<std::int32_t>(number));
}

// What a pass's constants make of those that its shaders declare.
void specialise(ProgramDesc& desc, const PassRow& pass, const ShaderInterface& interface) {
  for (const SpecConstantInfo& declared : interface.spec_constants) {
    if (const auto given = pass.constants.find(declared.name); given != pass.constants.end()) {
      desc.spec_constants.push_back({declared.id, bitsOf(given->second, declared.type)});
    }
  }
}

std::string keyOf(const std::map<std::string, UniformConstant>& constants) {
  std::string key;
  for (const auto& [name, value] : constants) {
    key +=
        fmt::format("|{}={}", name, std::visit([](auto given) { return fmt::format("{}", given); }, value));
  }
  return key;
}

// A shader put in a pass's place must write what the pass writes: the attachments' count and kinds.
Expected<void> checkOutputs(const PassRow& pass, const ShaderInterface& interface,
                            const std::string& shader) {
  const std::string attempted = fmt::format("use the shader for the pass '{}'", pass.name);
  for (std::size_t location = 0; location < pass.colour_formats.size(); ++location) {
    const auto output = std::ranges::find(interface.outputs, location, &StageVariable::location);
    if (output == interface.outputs.end()) {
      return inputError(attempted, fmt::format("it has no output at location {}", location), shader,
                        fmt::format("the pass needs {}", pass.colour_formats.size()));
    }
    const bool wants_integer = formatInfo(pass.colour_formats[location]).is_integer;
    if (wants_integer == (output->type == ScalarType::kFloat)) {
      return inputError(
          attempted,
          fmt::format("the output '{}' at location {} is {}", output->name, location,
                      wants_integer ? "float where integers are stored" : "integer where floats are stored"),
          shader);
    }
  }
  return {};
}

Expected<std::optional<UniformBlock>> singleBlock(const ShaderInterface& vertex,
                                                  const ShaderInterface& fragment,
                                                  const std::string& shader) {
  std::vector<UniformBlock> blocks = vertex.uniform_blocks;
  blocks.insert(blocks.end(), fragment.uniform_blocks.begin(), fragment.uniform_blocks.end());
  if (blocks.size() > 1) {
    return inputError("use the shader", fmt::format("it has {} uniform blocks", blocks.size()), shader,
                      "a pass has one, at binding 0");
  }
  return blocks.empty() ? std::nullopt : std::optional(blocks.front());
}

struct Stages {
  ShaderModule vertex;
  ShaderModule fragment;
  std::string fragment_file;  // for messages
};

Expected<Stages> compileStages(const PassRow& pass, const CompileSettings& settings, ShaderTarget target) {
  const auto replacement = settings.replacements.find(pass.name);
  const std::filesystem::path fragment_file = replacement != settings.replacements.end()
                                                  ? replacement->second
                                                  : std::filesystem::path(pass.fragment_shader);
  const CompileOptions options{.form = settings.form, .use_cache = true};
  auto vertex = compileShader({.root = settings.shader_root,
                               .entry = pass.vertex_shader,
                               .stage = ShaderStage::kVertex,
                               .defines = {}},
                              target, options);
  if (!vertex) {
    return tl::make_unexpected(vertex.error());
  }
  auto fragment = compileShader(
      {.root = settings.shader_root, .entry = fragment_file, .stage = ShaderStage::kFragment, .defines = {}},
      target, options);
  if (!fragment) {
    return tl::make_unexpected(fragment.error());
  }
  return Stages{std::move(*vertex), std::move(*fragment), fragment_file.string()};
}

// What draws with the program must know of it. Fails on shaders that no pass, or not this one, can be drawn
// with.
Expected<Program> describe(const PassRow& pass, const Stages& stages) {
  if (const auto checked = checkOutputs(pass, stages.fragment.interface, stages.fragment_file); !checked) {
    return tl::make_unexpected(checked.error());
  }
  auto block = singleBlock(stages.vertex.interface, stages.fragment.interface, stages.fragment_file);
  if (!block) {
    return tl::make_unexpected(block.error());
  }
  Program program{.shader = stages.fragment_file,
                  .device_program = {},
                  .samplers = stages.vertex.interface.samplers,
                  .uniform_block = *block,
                  .target_count = pass.colour_formats.size()};
  program.samplers.insert(program.samplers.end(), stages.fragment.interface.samplers.begin(),
                          stages.fragment.interface.samplers.end());
  return program;
}

// What the device makes it of. Points into `stages`.
ProgramDesc programDesc(const PassRow& pass, const Stages& stages, const Program& program) {
  ProgramDesc desc{.name = pass.name,
                   .vertex_spirv = stages.vertex.spirv,
                   .fragment_spirv = stages.fragment.spirv,
                   .spec_constants = {},
                   .vertex_constant_ids = constantIds(stages.vertex.interface),
                   .fragment_constant_ids = constantIds(stages.fragment.interface),
                   .sampler_bindings = {},
                   .uniform_bindings = {},
                   .vertex_attributes = pass.vertex_attributes,
                   .vertex_stride_bytes = pass.vertex_stride_bytes,
                   .colour_formats = pass.colour_formats,
                   .depth_test = pass.depth_test};
  specialise(desc, pass, stages.vertex.interface);
  specialise(desc, pass, stages.fragment.interface);
  for (const SamplerBinding& sampler : program.samplers) {
    desc.sampler_bindings.push_back(sampler.binding);
  }
  if (program.uniform_block) {
    desc.uniform_bindings.push_back(program.uniform_block->binding);
  }
  return desc;
}

}  // namespace

Expected<const Program*> Programs::get(const PassRow& pass, const CompileSettings& settings) {
  pass_names_.insert(pass.name);
  const auto replacement = settings.replacements.find(pass.name);
  const bool is_replaced = replacement != settings.replacements.end();
  const std::string key =
      fmt::format("{}|{}|{}|{}|{}|{}{}", pass.name, settings.shader_root.string(),
                  is_replaced ? replacement->second.string() : "", static_cast<int>(settings.form),
                  static_cast<int>(pass.depth_test), pass.colour_formats.size(), keyOf(pass.constants));
  const auto kept = kept_.find(key);
  if (kept != kept_.end() && !is_replaced) {
    return &kept->second;
  }
  auto made = make(pass, settings);
  if (!made) {
    return tl::make_unexpected(made.error());
  }
  return &kept_.insert_or_assign(key, std::move(*made)).first->second;
}

Expected<Program> Programs::make(const PassRow& pass, const CompileSettings& settings) {
  const PassClock compiling;
  const auto stages = compileStages(pass, settings, target_);
  if (!stages) {
    return tl::make_unexpected(stages.error());
  }
  times_.compile_ns += compiling.elapsed().wall_ns;
  auto program = describe(pass, *stages);
  if (!program) {
    return program;
  }
  const PassClock linking;
  auto device_program = device_.createProgram(programDesc(pass, *stages, *program));
  times_.pipeline_ns += linking.elapsed().wall_ns;
  if (!device_program) {
    return tl::make_unexpected(device_program.error());
  }
  program->device_program = std::move(*device_program);
  return program;
}

Expected<std::vector<SampledImage>> bindSamplers(const Program& program, const FrameImages& images,
                                                 const std::map<std::string, SampledImage>& aliases) {
  std::vector<SampledImage> bound;
  for (const SamplerBinding& sampler : program.samplers) {
    const auto alias = aliases.find(sampler.name);
    SampledImage sampled = alias != aliases.end() ? alias->second : images.sampled(sampler.name);
    if (sampled.image == nullptr) {
      return inputError("bind the shader's images", fmt::format("no image is called '{}'", sampler.name),
                        program.shader, "the frame has " + joinNames(images.names()));
    }
    const bool wants_float = sampler.kind == SamplerKind::kFloat;
    if (wants_float == formatInfo(sampled.image->desc().format).is_integer) {
      return inputError("bind the shader's images",
                        fmt::format("the sampler '{}' is of the wrong kind: the image holds {}", sampler.name,
                                    wants_float ? "integers" : "floats"),
                        program.shader);
    }
    sampled.binding = sampler.binding;
    bound.push_back(sampled);
  }
  return bound;
}

Expected<PassTime> drawFullScreen(Device& device, const Program& program, const FullScreenPass& pass,
                                  const FrameImages& images, const UniformValues& values) {
  auto sampled = bindSamplers(program, images, pass.aliases);
  if (!sampled) {
    return tl::make_unexpected(sampled.error());
  }
  std::vector<std::byte> uniforms;
  if (program.uniform_block) {
    auto packed = values.pack(*program.uniform_block, program.shader);
    if (!packed) {
      return tl::make_unexpected(packed.error());
    }
    uniforms = std::move(*packed);
  }
  PassDesc desc{.name = pass.row->name,
                .program = program.device_program.get(),
                .sampled = std::move(*sampled),
                .uniform_binding = program.uniform_block ? program.uniform_block->binding : 0,
                .uniforms = uniforms,
                .vertices = nullptr,
                .colour = pass.targets,
                .depth = pass.depth,
                .viewport = pass.viewport,
                .draws = {DrawCall{.first_vertex = 3 * static_cast<std::uint32_t>(pass.layer)}}};
  return device.draw(desc);
}

}  // namespace ssrkit
