#include <glslang/SPIRV/spirv.hpp>

#include <algorithm>
#include <bit>
#include <cstring>
#include <map>
#include <string_view>
#include <utility>

#include "shader/module_variants.h"
#include "shader/spirv_module.h"

namespace ssrkit {

namespace {

constexpr std::uint32_t kFloatBits = 32;
constexpr std::uint32_t kWordBytes = 4;

std::vector<std::uint32_t> literal(std::string_view text) {
  std::vector<std::uint32_t> words(text.size() / kWordBytes + 1);
  std::memcpy(words.data(), text.data(), text.size());
  return words;
}

bool isSum(std::uint32_t opcode) {
  switch (opcode) {
    case spv::OpFAdd:
    case spv::OpFSub:
    case spv::OpFMul:
    case spv::OpFDiv:
    case spv::OpVectorTimesScalar:
    case spv::OpDot:
      return true;
    default:
      return false;
  }
}

class Injection {
 public:
  Injection(SpirvModule& module, const UniformBlockIds& block) : module_(module), block_(block) {
    float_ = module.type(spv::OpTypeFloat, {kFloatBits});
    bool_ = module.type(spv::OpTypeBool, {});
    pointer_ = module.type(spv::OpTypePointer, {spv::StorageClassUniform, float_});
    one_ = module.constant(float_, std::bit_cast<std::uint32_t>(1.0F));
    addMember();
    for (const SpirvLine& line : module.lines()) {
      if (line.opcode == spv::OpEntryPoint) {
        entry_ = line.operands[1];
        is_fragment_ = line.operands[0] == spv::ExecutionModelFragment;
      } else if (line.opcode == spv::OpTypeVector && line.operands[1] == float_) {
        vectors_.emplace(line.operands[0], line.operands[2]);
      } else if (line.opcode == spv::OpDecorate && line.operands[1] == spv::DecorationNoContraction) {
        exact_.push_back(line.operands[0]);
      }
    }
  }

  void run() {
    std::vector<SpirvLine> lines = std::exchange(module_.lines(), {});
    std::uint32_t function = 0;
    bool at_start = false;  // of a function's body: its variables come first
    for (SpirvLine& line : lines) {
      if (at_start && line.opcode != spv::OpVariable && line.opcode != spv::OpLabel) {
        at_start = false;
        begin(function);
      }
      if (line.opcode == spv::OpFunction) {
        function = line.operands[1];
        split_from_ = split_to_ = 0;
      } else if (line.opcode == spv::OpLabel) {
        at_start = at_start || startsBody();
        label_ = line.operands[0];
      } else if (line.opcode == spv::OpPhi) {
        replacePredecessor(line);
      }
      add(std::move(line));
    }
    keepExact();
  }

 private:
  [[nodiscard]] bool startsBody() const {
    const std::uint32_t before = module_.lines().back().opcode;
    return before == spv::OpFunction || before == spv::OpFunctionParameter;
  }

  void emit(std::uint32_t opcode, std::vector<std::uint32_t> operands) {
    module_.lines().push_back({opcode, std::move(operands)});
  }

  // The member at the end of the block.
  void addMember() {
    std::uint32_t end = 0;
    const SpirvLine* const type = module_.declarationOf(block_.structure);
    const auto count = static_cast<std::uint32_t>(type->operands.size()) - 1;
    for (std::uint32_t member = 0; member < count; ++member) {
      const auto offset = module_.decoration(block_.structure, member, spv::DecorationOffset).value_or(0);
      end = std::max(end, offset + extentOf(module_, block_.structure, member).size_bytes);
    }
    const std::uint32_t int_type = module_.type(spv::OpTypeInt, {kFloatBits, 1});
    member_ = module_.constant(int_type, count);
    std::vector<SpirvLine>& lines = module_.lines();
    std::vector<std::uint32_t> name = literal(kDeadCodeZero);
    name.insert(name.begin(), {block_.structure, count});
    const auto first_of_block = [this](std::uint32_t opcode) {
      return [this, opcode](const SpirvLine& line) {
        return line.opcode == opcode && line.operands[0] == block_.structure;
      };
    };
    lines.insert(std::ranges::find_if(lines, first_of_block(spv::OpMemberName)),
                 SpirvLine{spv::OpMemberName, name});
    lines.insert(std::ranges::find_if(lines, first_of_block(spv::OpMemberDecorate)),
                 SpirvLine{spv::OpMemberDecorate, {block_.structure, count, spv::DecorationOffset, end}});
    // The float may have been declared behind the block; it leans on nothing and may stand before.
    std::erase_if(lines, [](const SpirvLine& line) { return line.opcode == spv::OpTypeFloat; });
    const auto structure = std::ranges::find_if(lines, first_of_block(spv::OpTypeStruct));
    structure->operands.push_back(float_);
    const auto first_type =
        std::ranges::find_if(lines, [](const SpirvLine& line) { return line.opcode == spv::OpTypeVoid; });
    lines.insert(first_type, SpirvLine{spv::OpTypeFloat, {float_, kFloatBits}});
  }

  // The zero as a scalar and as vectors, and in the entry point the branch that is never taken.
  void begin(std::uint32_t function) {
    const std::uint32_t pointer = module_.newId();
    const std::uint32_t zero = module_.newId();
    emit(spv::OpAccessChain, {pointer_, pointer, block_.variable, member_});
    emit(spv::OpLoad, {float_, zero, pointer});
    zeros_ = {{float_, zero}};
    for (const auto& [type, components] : vectors_) {
      const std::uint32_t vector = module_.newId();
      std::vector<std::uint32_t> operands = {type, vector};
      operands.insert(operands.end(), components, zero);
      emit(spv::OpCompositeConstruct, std::move(operands));
      zeros_.emplace(type, vector);
    }
    if (function == entry_) {
      branch(zero);
    }
  }

  void branch(std::uint32_t zero) {
    const std::uint32_t condition = module_.newId();
    const std::uint32_t dead = module_.newId();
    split_from_ = label_;
    split_to_ = module_.newId();
    emit(spv::OpFOrdGreaterThan, {bool_, condition, zero, one_});
    emit(spv::OpSelectionMerge, {split_to_, spv::SelectionControlMaskNone});
    emit(spv::OpBranchConditional, {condition, dead, split_to_});
    emit(spv::OpLabel, {dead});
    emit(is_fragment_ ? spv::OpKill : spv::OpReturn, {});
    emit(spv::OpLabel, {split_to_});
  }

  // The rest of the first block has another label now.
  void replacePredecessor(SpirvLine& phi) const {
    for (std::size_t i = 3; i < phi.operands.size(); i += 2) {
      phi.operands[i] = phi.operands[i] == split_from_ && split_from_ != 0 ? split_to_ : phi.operands[i];
    }
  }

  void add(SpirvLine line) {
    const auto zero = isSum(line.opcode) ? zeros_.find(line.operands[0]) : zeros_.end();
    if (zero == zeros_.end()) {
      module_.lines().push_back(std::move(line));
      return;
    }
    const std::uint32_t result = line.operands[1];
    line.operands[1] = module_.newId();
    inner_of_[result] = line.operands[1];
    const std::uint32_t inner = line.operands[1];
    module_.lines().push_back(std::move(line));
    emit(spv::OpFAdd, {zero->first, result, inner, zero->second});
  }

  // What was `precise` stays so in both halves.
  void keepExact() {
    std::vector<SpirvLine>& lines = module_.lines();
    for (const std::uint32_t id : exact_) {
      const auto inner = inner_of_.find(id);
      const auto place =
          std::ranges::find_if(lines, [](const SpirvLine& line) { return line.opcode == spv::OpDecorate; });
      if (inner != inner_of_.end()) {
        lines.insert(place, SpirvLine{spv::OpDecorate, {inner->second, spv::DecorationNoContraction}});
      }
    }
  }

  SpirvModule& module_;
  UniformBlockIds block_;
  std::uint32_t float_ = 0;
  std::uint32_t bool_ = 0;
  std::uint32_t pointer_ = 0;
  std::uint32_t one_ = 0;
  std::uint32_t member_ = 0;
  std::uint32_t entry_ = 0;
  bool is_fragment_ = false;
  std::map<std::uint32_t, std::uint32_t> vectors_;  // types, with their components
  std::vector<std::uint32_t> exact_;
  std::map<std::uint32_t, std::uint32_t> zeros_;  // by type, of this function
  std::map<std::uint32_t, std::uint32_t> inner_of_;
  std::uint32_t label_ = 0;  // of the block that is being copied
  std::uint32_t split_from_ = 0;
  std::uint32_t split_to_ = 0;
};

}  // namespace

std::vector<std::uint32_t> withDeadCode(std::span<const std::uint32_t> spirv) {
  SpirvModule module(spirv);
  const auto block = uniformBlockOf(module);
  if (!block) {
    return {spirv.begin(), spirv.end()};
  }
  Injection(module, *block).run();
  return module.words();
}

}  // namespace ssrkit
