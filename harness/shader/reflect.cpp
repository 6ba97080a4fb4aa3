#include "shader/reflect.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <spirv_cross/spirv_cross.hpp>

#include "shader/reflect_blocks.h"
#include "shader/reflect_error.h"
#include "shader/spirv_instructions.h"

namespace ssrkit {

namespace {

using Resources = spirv_cross::SmallVector<spirv_cross::Resource>;

class Reflection {
 public:
  explicit Reflection(const std::vector<std::uint32_t>& spirv) : spirv_(spirv), compiler_(spirv) {}

  [[nodiscard]] ShaderInterface read() {
    const spirv_cross::ShaderResources resources = compiler_.get_shader_resources();
    refuseUnbindable(resources);
    refuseLooseUniforms(resources.sampled_images);
    for (const spirv_cross::Resource& sampler : resources.sampled_images) {
      addSampler(sampler);
    }
    for (const spirv_cross::Resource& block : resources.uniform_buffers) {
      claimBinding(block);
      interface_.uniform_blocks.push_back(reflectBlock(compiler_, block));
    }
    addVariables(resources.stage_inputs, interface_.inputs);
    addVariables(resources.stage_outputs, interface_.outputs);
    for (const spirv_cross::SpecializationConstant& constant : compiler_.get_specialization_constants()) {
      addSpecConstant(constant);
    }
    std::ranges::sort(interface_.samplers, {}, &SamplerBinding::binding);
    std::ranges::sort(interface_.uniform_blocks, {}, &UniformBlock::binding);
    std::ranges::sort(interface_.spec_constants, {}, &SpecConstantInfo::id);
    return std::move(interface_);
  }

 private:
  static void refuse(const Resources& resources, std::string_view what) {
    if (!resources.empty()) {
      throw UnsupportedInterface(fmt::format("'{}' is {}; a pass reads combined samplers and std140 blocks",
                                             resources[0].name, what));
    }
  }

  static void refuseUnbindable(const spirv_cross::ShaderResources& resources) {
    refuse(resources.storage_images, "a storage image");
    refuse(resources.storage_buffers, "a storage buffer");
    refuse(resources.push_constant_buffers, "a push constant block");
    refuse(resources.separate_images, "an image without its sampler");
    refuse(resources.separate_samplers, "a sampler without its image");
    refuse(resources.subpass_inputs, "a subpass input");
    refuse(resources.atomic_counters, "an atomic counter");
  }

  // SPIRV-Cross lists every uniform but the loose ones of OpenGL.
  void refuseLooseUniforms(const Resources& samplers) const {
    forEachInstruction(spirv_, [&](const Instruction& instruction) {
      if (instruction.opcode != spv::OpVariable ||
          instruction.operands[2] != spv::StorageClassUniformConstant) {
        return;
      }
      const std::uint32_t id = instruction.operands[1];
      if (std::ranges::none_of(samplers,
                               [id](const spirv_cross::Resource& sampler) { return sampler.id == id; })) {
        throw UnsupportedInterface(fmt::format(
            "'{}' is a uniform outside a block; put it into a std140 block", compiler_.get_name(id)));
      }
    });
  }

  void claimBinding(const spirv_cross::Resource& resource) {
    if (compiler_.get_decoration(resource.id, spv::DecorationDescriptorSet) != 0) {
      throw UnsupportedInterface(fmt::format("'{}' is in another set than 0", resource.name));
    }
    if (!compiler_.has_decoration(resource.id, spv::DecorationBinding)) {
      throw UnsupportedInterface(fmt::format("'{}' has no layout(binding = N)", resource.name));
    }
    const std::uint32_t binding = compiler_.get_decoration(resource.id, spv::DecorationBinding);
    const auto [owner, is_new] = bindings_.emplace(binding, resource.name);
    if (!is_new) {
      throw UnsupportedInterface(
          fmt::format("'{}' and '{}' share binding {}; Vulkan numbers all of them in one row", owner->second,
                      resource.name, binding));
    }
  }

  void addSampler(const spirv_cross::Resource& resource) {
    claimBinding(resource);
    const spirv_cross::SPIRType& type = compiler_.get_type(resource.type_id);
    if (!type.array.empty()) {
      throw UnsupportedInterface(
          fmt::format("'{}' is an array of samplers; give each its own name", resource.name));
    }
    const ScalarType scalar = scalarTypeOf(compiler_.get_type(type.image.type), resource.name);
    const SamplerKind kind = scalar == ScalarType::kInt    ? SamplerKind::kInt
                             : scalar == ScalarType::kUint ? SamplerKind::kUint
                                                           : SamplerKind::kFloat;
    interface_.samplers.push_back(
        {resource.name, compiler_.get_decoration(resource.id, spv::DecorationBinding), kind});
  }

  void addVariables(const Resources& resources, std::vector<StageVariable>& variables) {
    for (const spirv_cross::Resource& resource : resources) {
      const spirv_cross::SPIRType& type = compiler_.get_type(resource.type_id);
      const std::uint32_t location = compiler_.get_decoration(resource.id, spv::DecorationLocation);
      if (type.basetype == spirv_cross::SPIRType::Struct) {
        addBlockVariables(compiler_.get_type(resource.base_type_id), resource.name, location, variables);
      } else {
        addVariable(type, resource.name, location, variables);
      }
    }
    std::ranges::sort(variables, {}, &StageVariable::location);
  }

  // One entry a location: an array and a matrix take several.
  std::uint32_t addVariable(const spirv_cross::SPIRType& type, const std::string& name,
                            std::uint32_t location, std::vector<StageVariable>& variables) {
    const std::uint32_t element_count = arrayCount(compiler_, type, name);
    const std::uint32_t count = std::max(element_count, 1U) * type.columns;
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::string shown = count == 1 && element_count == 0 ? name : fmt::format("{}[{}]", name, i);
      variables.push_back({shown, location + i, scalarTypeOf(type, name), type.vecsize});
    }
    return count;
  }

  void addBlockVariables(const spirv_cross::SPIRType& type, const std::string& name, std::uint32_t location,
                         std::vector<StageVariable>& variables) {
    for (std::uint32_t i = 0; i < type.member_types.size(); ++i) {
      if (compiler_.has_member_decoration(type.self, i, spv::DecorationLocation)) {
        location = compiler_.get_member_decoration(type.self, i, spv::DecorationLocation);
      }
      location += addVariable(compiler_.get_type(type.member_types[i]),
                              fmt::format("{}.{}", name, compiler_.get_member_name(type.self, i)), location,
                              variables);
    }
  }

  void addSpecConstant(const spirv_cross::SpecializationConstant& constant) {
    const spirv_cross::SPIRConstant& value = compiler_.get_constant(constant.id);
    const std::string name = compiler_.get_name(constant.id);
    const ScalarType type = scalarTypeOf(compiler_.get_type(value.constant_type), name);
    interface_.spec_constants.push_back({name, constant.constant_id, type, value.scalar()});
  }

  const std::vector<std::uint32_t>& spirv_;
  spirv_cross::Compiler compiler_;
  ShaderInterface interface_;
  std::map<std::uint32_t, std::string> bindings_;
};

}  // namespace

Expected<ShaderInterface> reflectSpirv(const std::vector<std::uint32_t>& spirv, const std::string& where,
                                       const std::string& attempted) {
  try {
    return Reflection(spirv).read();
  } catch (const UnsupportedInterface& problem) {
    return inputError(attempted, problem.what(), where);
  } catch (const spirv_cross::CompilerError& problem) {
    return inputError(attempted, fmt::format("its interface cannot be read: {}", problem.what()), where);
  }
}

}  // namespace ssrkit
