#include "device/vulkan/module_rules.h"

#include <fmt/format.h>

#include <algorithm>

#include "shader/spirv_instructions.h"

namespace ssrkit::vulkan {

namespace {

// SPIR-V specification, sections 3.3 (execution models), 3.20 (decorations) and 3.49 (instructions).
constexpr std::uint32_t kOpEntryPoint = 15;
constexpr std::uint32_t kOpDecorate = 71;
constexpr std::uint32_t kDecorationLocation = 30;
constexpr std::uint32_t kDecorationDescriptorSet = 34;
constexpr std::uint32_t kModelVertex = 0;
constexpr std::uint32_t kModelFragment = 4;

struct ModuleFacts {
  bool has_main = false;
  std::uint32_t highest_location = 0;
  std::uint32_t highest_set = 0;
};

ModuleFacts factsOf(std::span<const std::uint32_t> words, std::uint32_t wanted_model) {
  ModuleFacts facts;
  forEachInstruction(words, [&](const Instruction& instruction) {
    const auto& operands = instruction.operands;
    if (operands.size() < 3) {
      return;
    }
    if (instruction.opcode == kOpEntryPoint) {
      facts.has_main |= operands[0] == wanted_model && literalString(operands.subspan(2)) == "main";
    } else if (instruction.opcode == kOpDecorate && operands[1] == kDecorationLocation) {
      facts.highest_location = std::max(facts.highest_location, operands[2]);
    } else if (instruction.opcode == kOpDecorate && operands[1] == kDecorationDescriptorSet) {
      facts.highest_set = std::max(facts.highest_set, operands[2]);
    }
  });
  return facts;
}

}  // namespace

Expected<void> checkModule(std::span<const std::uint32_t> words, VkShaderStageFlagBits stage,
                           const VkPhysicalDeviceLimits& limits, const std::string& attempted) {
  const bool is_vertex = stage == VK_SHADER_STAGE_VERTEX_BIT;
  const char* const name = is_vertex ? "vertex" : "fragment";
  const ModuleFacts facts = factsOf(words, is_vertex ? kModelVertex : kModelFragment);
  if (!facts.has_main) {
    return inputError(attempted, fmt::format("its {} module has no {} shader named main", name, name));
  }
  if (facts.highest_set > 0) {
    return inputError(attempted,
                      fmt::format("its {} shader uses descriptor set {} and the kit has set 0 alone", name,
                                  facts.highest_set),
                      {}, "leave 'set' out of the layout");
  }
  const std::uint32_t location_count =
      std::min(limits.maxVertexOutputComponents, limits.maxFragmentInputComponents) / 4;
  if (facts.highest_location >= location_count) {
    return inputError(attempted,
                      fmt::format("its {} shader uses location {} and the device has 0 to {}", name,
                                  facts.highest_location, location_count - 1),
                      {}, "number the inputs and outputs from 0");
  }
  return {};
}

}  // namespace ssrkit::vulkan
