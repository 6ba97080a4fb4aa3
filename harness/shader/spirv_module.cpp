#include "shader/spirv_module.h"

#include <glslang/SPIRV/spirv.hpp>

#include <algorithm>

#include "base/check.h"
#include "shader/spirv_instructions.h"

namespace ssrkit {

namespace {

constexpr std::size_t kHeaderWords = 5;
constexpr std::size_t kBoundWord = 3;
constexpr std::uint32_t kCountShift = 16;

bool isType(std::uint32_t opcode) {
  return opcode >= spv::OpTypeVoid && opcode <= spv::OpTypePipe;
}

bool isConstant(std::uint32_t opcode) {
  return opcode == spv::OpConstant || opcode == spv::OpSpecConstant;
}

std::uint32_t roundedUp(std::uint32_t value, std::uint32_t multiple) {
  return (value + multiple - 1) / multiple * multiple;
}

constexpr std::uint32_t kScalarBytes = 4;
constexpr std::uint32_t kVec4Bytes = 16;

MemberExtent extentOfStruct(const SpirvModule& module, const SpirvLine& type) {
  std::uint32_t end = 0;
  const auto count = static_cast<std::uint32_t>(type.operands.size()) - 1;
  for (std::uint32_t member = 0; member < count; ++member) {
    const std::uint32_t offset =
        module.decoration(type.operands[0], member, spv::DecorationOffset).value_or(0);
    end = std::max(end, offset + extentOf(module, type.operands[0], member).size_bytes);
  }
  return {roundedUp(end, kVec4Bytes), kVec4Bytes};
}

}  // namespace

SpirvModule::SpirvModule(std::span<const std::uint32_t> words)
    : header_(words.begin(), words.begin() + kHeaderWords), bound_(words[kBoundWord]) {
  forEachInstruction(words, [this](const Instruction& instruction) {
    lines_.push_back({instruction.opcode, {instruction.operands.begin(), instruction.operands.end()}});
  });
}

std::vector<std::uint32_t> SpirvModule::words() const {
  std::vector<std::uint32_t> words = header_;
  words[kBoundWord] = bound_;
  for (const SpirvLine& line : lines_) {
    const auto count = static_cast<std::uint32_t>(line.operands.size()) + 1;
    words.push_back(count << kCountShift | line.opcode);
    words.insert(words.end(), line.operands.begin(), line.operands.end());
  }
  return words;
}

std::size_t SpirvModule::firstFunction() const {
  const auto found =
      std::ranges::find(lines_, static_cast<std::uint32_t>(spv::OpFunction), &SpirvLine::opcode);
  return static_cast<std::size_t>(found - lines_.begin());
}

std::uint32_t SpirvModule::type(std::uint32_t opcode, const std::vector<std::uint32_t>& operands) {
  SSRKIT_CHECK(isType(opcode));
  for (const SpirvLine& line : lines_) {
    if (line.opcode == opcode &&
        std::equal(line.operands.begin() + 1, line.operands.end(), operands.begin(), operands.end())) {
      return line.operands[0];
    }
  }
  SpirvLine line{opcode, {newId()}};
  line.operands.insert(line.operands.end(), operands.begin(), operands.end());
  const std::uint32_t id = line.operands[0];
  lines_.insert(lines_.begin() + static_cast<std::ptrdiff_t>(firstFunction()), std::move(line));
  return id;
}

std::uint32_t SpirvModule::constant(std::uint32_t type_id, std::uint32_t bits) {
  for (const SpirvLine& line : lines_) {
    if (line.opcode == spv::OpConstant && line.operands[0] == type_id && line.operands[2] == bits) {
      return line.operands[1];
    }
  }
  const std::uint32_t id = newId();
  lines_.insert(lines_.begin() + static_cast<std::ptrdiff_t>(firstFunction()),
                SpirvLine{spv::OpConstant, {type_id, id, bits}});
  return id;
}

const SpirvLine* SpirvModule::declarationOf(std::uint32_t id) const {
  const auto found = std::ranges::find_if(lines_, [id](const SpirvLine& line) {
    return (isType(line.opcode) && line.operands[0] == id) ||
           (isConstant(line.opcode) && line.operands[1] == id);
  });
  return found == lines_.end() ? nullptr : &*found;
}

std::optional<std::uint32_t> SpirvModule::decoration(std::uint32_t id, std::uint32_t decoration) const {
  for (const SpirvLine& line : lines_) {
    if (line.opcode == spv::OpDecorate && line.operands[0] == id && line.operands[1] == decoration) {
      return line.operands.size() > 2 ? line.operands[2] : 0;
    }
  }
  return std::nullopt;
}

std::optional<std::uint32_t> SpirvModule::decoration(std::uint32_t struct_id, std::uint32_t member,
                                                     std::uint32_t decoration) const {
  for (const SpirvLine& line : lines_) {
    if (line.opcode == spv::OpMemberDecorate && line.operands[0] == struct_id && line.operands[1] == member &&
        line.operands[2] == decoration) {
      return line.operands.size() > 3 ? line.operands[3] : 0;
    }
  }
  return std::nullopt;
}

std::optional<UniformBlockIds> uniformBlockOf(const SpirvModule& module) {
  for (const SpirvLine& line : module.lines()) {
    if (line.opcode != spv::OpVariable || line.operands[2] != spv::StorageClassUniform) {
      continue;
    }
    const SpirvLine* const pointer = module.declarationOf(line.operands[0]);
    if (pointer != nullptr && module.decoration(pointer->operands[2], spv::DecorationBlock)) {
      return UniformBlockIds{line.operands[1], pointer->operands[2]};
    }
  }
  return std::nullopt;
}

MemberExtent extentOf(const SpirvModule& module, std::uint32_t struct_id, std::uint32_t member) {
  const SpirvLine* const structure = module.declarationOf(struct_id);
  SSRKIT_CHECK(structure != nullptr);
  const std::uint32_t type_id = structure->operands.at(member + 1);
  const SpirvLine* const type = module.declarationOf(type_id);
  SSRKIT_CHECK(type != nullptr);
  switch (type->opcode) {
    case spv::OpTypeVector: {
      const std::uint32_t count = type->operands[2];
      return {count * kScalarBytes, (count == 2 ? 2 : 4) * kScalarBytes};
    }
    case spv::OpTypeMatrix: {
      const auto stride =
          module.decoration(struct_id, member, spv::DecorationMatrixStride).value_or(kVec4Bytes);
      return {type->operands[2] * stride, kVec4Bytes};
    }
    case spv::OpTypeArray: {
      const SpirvLine* const length = module.declarationOf(type->operands[2]);
      SSRKIT_CHECK(length != nullptr);
      return {
          length->operands[2] * module.decoration(type_id, spv::DecorationArrayStride).value_or(kVec4Bytes),
          kVec4Bytes};
    }
    case spv::OpTypeStruct:
      return extentOfStruct(module, *type);
    default:
      return {kScalarBytes, kScalarBytes};
  }
}

}  // namespace ssrkit
