#include "shader/endless_loop.h"

#include <glslang/SPIRV/spirv.hpp>

#include <limits>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "shader/spirv_instructions.h"

namespace ssrkit {

namespace {

using Id = std::uint32_t;

struct Block {
  std::vector<Id> successors;
  bool leaves_function = false;
};

struct Loop {
  Id header = 0;
  std::size_t index = 0;  // among the module's loops
};

struct Function {
  Id first_block = 0;
  std::unordered_map<Id, Block> blocks;
  std::vector<Loop> loops;
};

class ModuleReader {
 public:
  [[nodiscard]] std::vector<Function> read(std::span<const std::uint32_t> spirv) {
    forEachInstruction(spirv, [this](const Instruction& instruction) { add(instruction); });
    return std::move(functions_);
  }

 private:
  void add(const Instruction& instruction) {
    switch (instruction.opcode) {
      case spv::OpConstantTrue:
        constants_[instruction.operands[1]] = true;
        break;
      case spv::OpConstantFalse:
        constants_[instruction.operands[1]] = false;
        break;
      case spv::OpFunction:
        functions_.emplace_back();
        break;
      case spv::OpLabel:
        startBlock(instruction.operands[0]);
        break;
      case spv::OpLoopMerge:
        functions_.back().loops.push_back({block_, loop_count_++});
        break;
      default:
        endBlock(instruction);
    }
  }

  void startBlock(Id label) {
    Function& function = functions_.back();
    block_ = label;
    function.first_block = function.first_block == 0 ? label : function.first_block;
    function.blocks[label] = {};
  }

  void endBlock(const Instruction& instruction) {
    const std::span<const std::uint32_t> operands = instruction.operands;
    switch (instruction.opcode) {
      case spv::OpBranch:
        current().successors = {operands[0]};
        break;
      case spv::OpBranchConditional: {
        const auto constant = constants_.find(operands[0]);
        current().successors = constant == constants_.end() ? std::vector<Id>{operands[1], operands[2]}
                               : constant->second           ? std::vector<Id>{operands[1]}
                                                            : std::vector<Id>{operands[2]};
        break;
      }
      case spv::OpSwitch:  // selector, default, then pairs of a 32-bit literal and a label
        current().successors = {operands[1]};
        for (std::size_t i = 3; i < operands.size(); i += 2) {
          current().successors.push_back(operands[i]);
        }
        break;
      case spv::OpReturn:
      case spv::OpReturnValue:
      case spv::OpKill:
      case spv::OpTerminateInvocation:
      case spv::OpUnreachable:
        current().leaves_function = true;
        break;
      default:
        break;
    }
  }

  Block& current() { return functions_.back().blocks[block_]; }

  std::vector<Function> functions_;
  std::unordered_map<Id, bool> constants_;
  Id block_ = 0;
  std::size_t loop_count_ = 0;
};

struct Reach {
  std::unordered_set<Id> blocks;
  bool leaves_function = false;
};

Reach reachFrom(const Function& function, Id start) {
  Reach reach;
  std::vector<Id> open{start};
  while (!open.empty()) {
    const Id id = open.back();
    open.pop_back();
    const auto block = function.blocks.find(id);
    if (block == function.blocks.end() || !reach.blocks.insert(id).second) {
      continue;
    }
    reach.leaves_function = reach.leaves_function || block->second.leaves_function;
    open.insert(open.end(), block->second.successors.begin(), block->second.successors.end());
  }
  return reach;
}

}  // namespace

std::optional<std::size_t> findEndlessLoop(std::span<const std::uint32_t> spirv) {
  for (const Function& function : ModuleReader().read(spirv)) {
    const Reach live = reachFrom(function, function.first_block);
    std::optional<std::size_t> culprit;
    std::size_t culprit_size = std::numeric_limits<std::size_t>::max();
    for (const Loop& loop : function.loops) {
      if (!live.blocks.contains(loop.header)) {
        continue;
      }
      const Reach reach = reachFrom(function, loop.header);
      // A loop around an endless loop may be endless too; the culprit is the one that reaches least.
      if (!reach.leaves_function && reach.blocks.size() < culprit_size) {
        culprit = loop.index;
        culprit_size = reach.blocks.size();
      }
    }
    if (culprit) {
      return culprit;
    }
  }
  return std::nullopt;
}

std::optional<LineOfSource> findLineOfLoop(std::span<const std::uint32_t> spirv, std::size_t loop_index) {
  std::unordered_map<Id, std::string> strings;
  LineOfSource line;
  std::optional<LineOfSource> found;
  std::size_t loop = 0;
  forEachInstruction(spirv, [&](const Instruction& instruction) {
    if (instruction.opcode == spv::OpString) {
      strings[instruction.operands[0]] = literalString(instruction.operands.subspan(1));
    } else if (instruction.opcode == spv::OpLine) {
      line = {strings[instruction.operands[0]], static_cast<int>(instruction.operands[1])};
    } else if (instruction.opcode == spv::OpLoopMerge && loop++ == loop_index && line.line > 0) {
      found = line;
    }
  });
  return found;
}

}  // namespace ssrkit
