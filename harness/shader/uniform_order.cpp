#include <glslang/SPIRV/spirv.hpp>

#include <algorithm>
#include <map>

#include "base/check.h"
#include "shader/module_variants.h"
#include "shader/spirv_module.h"

namespace ssrkit {

namespace {

// By member, in the opposite order of today's.
std::vector<std::uint32_t> reversedOffsets(const SpirvModule& module, std::uint32_t structure,
                                           std::uint32_t count) {
  std::vector<std::uint32_t> offsets(count);
  std::uint32_t end = 0;
  for (std::uint32_t member = count; member-- > 0;) {
    const MemberExtent extent = extentOf(module, structure, member);
    offsets[member] = (end + extent.alignment_bytes - 1) / extent.alignment_bytes * extent.alignment_bytes;
    end = offsets[member] + extent.size_bytes;
  }
  return offsets;
}

void reverseDeclaration(SpirvModule& module, std::uint32_t structure,
                        const std::vector<std::uint32_t>& offsets) {
  const auto last = static_cast<std::uint32_t>(offsets.size()) - 1;
  for (SpirvLine& line : module.lines()) {
    const bool is_of_block = !line.operands.empty() && line.operands[0] == structure;
    if (is_of_block && line.opcode == spv::OpTypeStruct) {
      std::reverse(line.operands.begin() + 1, line.operands.end());
    } else if (is_of_block && (line.opcode == spv::OpMemberName || line.opcode == spv::OpMemberDecorate)) {
      if (line.opcode == spv::OpMemberDecorate && line.operands[2] == spv::DecorationOffset) {
        line.operands[3] = offsets[line.operands[1]];
      }
      line.operands[1] = last - line.operands[1];
    }
  }
}

// The constants that name the members where the block is read, by the constants that named them.
std::map<std::uint32_t, std::uint32_t> reversedIndices(SpirvModule& module, std::uint32_t variable,
                                                       std::uint32_t last) {
  std::map<std::uint32_t, std::uint32_t> reversed;
  for (const SpirvLine& line : module.lines()) {
    const bool is_access = line.opcode == spv::OpAccessChain || line.opcode == spv::OpInBoundsAccessChain;
    if (is_access && line.operands[2] == variable) {
      reversed.emplace(line.operands[3], 0);
    }
  }
  for (auto& [index, replacement] : reversed) {
    const SpirvLine* const constant = module.declarationOf(index);
    SSRKIT_CHECK(constant != nullptr);  // a structure is indexed by constants alone
    replacement = module.constant(constant->operands[0], last - constant->operands[2]);
  }
  return reversed;
}

}  // namespace

std::vector<std::uint32_t> withUniformsReversed(std::span<const std::uint32_t> spirv) {
  SpirvModule module(spirv);
  const auto block = uniformBlockOf(module);
  const SpirvLine* const type = block ? module.declarationOf(block->structure) : nullptr;
  if (type == nullptr) {
    return {spirv.begin(), spirv.end()};
  }
  const auto count = static_cast<std::uint32_t>(type->operands.size()) - 1;
  reverseDeclaration(module, block->structure, reversedOffsets(module, block->structure, count));
  const auto indices = reversedIndices(module, block->variable, count - 1);
  for (SpirvLine& line : module.lines()) {
    const bool is_access = line.opcode == spv::OpAccessChain || line.opcode == spv::OpInBoundsAccessChain;
    if (is_access && line.operands[2] == block->variable) {
      line.operands[3] = indices.at(line.operands[3]);
    }
  }
  return module.words();
}

}  // namespace ssrkit
