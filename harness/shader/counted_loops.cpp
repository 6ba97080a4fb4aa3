#include <glslang/SPIRV/spirv.hpp>

#include <algorithm>
#include <bit>
#include <utility>

#include "shader/module_variants.h"
#include "shader/spirv_module.h"

namespace ssrkit {

namespace {

constexpr std::uint32_t kWordBits = 32;

class LoopCounter {
 public:
  LoopCounter(SpirvModule& module, std::uint32_t limit) : module_(module) {
    uint_ = module.type(spv::OpTypeInt, {kWordBits, 0});
    bool_ = module.type(spv::OpTypeBool, {});
    const std::uint32_t pointer = module.type(spv::OpTypePointer, {spv::StorageClassPrivate, uint_});
    const std::uint32_t zero = module.constant(uint_, 0);
    one_ = module.constant(uint_, 1);
    limit_ = module.constant(uint_, limit);
    findOutputs();
    counter_ = module.newId();
    const auto function =
        std::ranges::find(module.lines(), static_cast<std::uint32_t>(spv::OpFunction), &SpirvLine::opcode);
    module.lines().insert(function,
                          SpirvLine{spv::OpVariable, {pointer, counter_, spv::StorageClassPrivate, zero}});
    for (const SpirvLine& line : module.lines()) {
      entry_ = line.opcode == spv::OpEntryPoint ? line.operands[1] : entry_;
    }
  }

  void run() {
    const std::vector<SpirvLine> lines = std::exchange(module_.lines(), {});
    std::uint32_t function = 0;
    bool count_here = false;  // the block that has begun is a loop's header
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const SpirvLine& line = lines[i];
      if (count_here && line.opcode != spv::OpPhi) {
        count();
        count_here = false;
      }
      if (line.opcode == spv::OpFunction) {
        function = line.operands[1];
      } else if (line.opcode == spv::OpLabel) {
        count_here = isHeader(lines, i);
      }
      if (line.opcode == spv::OpReturn && function == entry_) {
        overturnIfOver();
      }
      module_.lines().push_back(line);
    }
  }

 private:
  static bool isHeader(const std::vector<SpirvLine>& lines, std::size_t label) {
    for (std::size_t i = label + 1; i < lines.size() && lines[i].opcode != spv::OpLabel; ++i) {
      if (lines[i].opcode == spv::OpLoopMerge) {
        return true;
      }
    }
    return false;
  }

  void emit(std::uint32_t opcode, std::vector<std::uint32_t> operands) {
    module_.lines().push_back({opcode, std::move(operands)});
  }

  void count() {
    const std::uint32_t before = module_.newId();
    const std::uint32_t after = module_.newId();
    emit(spv::OpLoad, {uint_, before, counter_});
    emit(spv::OpIAdd, {uint_, after, before, one_});
    emit(spv::OpStore, {counter_, after});
  }

  // What an output holds, and for floats what takes the place of what it held.
  struct Output {
    std::uint32_t variable = 0;
    std::uint32_t type = 0;
    std::uint32_t components = 1;
    bool is_float = false;
    std::uint32_t truths = 0;  // the type of as many booleans
    std::uint32_t half = 0;
    std::uint32_t ones = 0;
    std::uint32_t zeros = 0;
  };

  void findOutputs() {
    const std::vector<SpirvLine> lines = module_.lines();
    for (const SpirvLine& line : lines) {
      if (line.opcode != spv::OpVariable || line.operands[2] != spv::StorageClassOutput ||
          !module_.decoration(line.operands[1], spv::DecorationLocation)) {
        continue;
      }
      Output output{.variable = line.operands[1]};
      output.type = module_.declarationOf(line.operands[0])->operands[2];
      const SpirvLine* type = module_.declarationOf(output.type);
      if (type->opcode == spv::OpTypeVector) {
        output.components = type->operands[2];
        type = module_.declarationOf(type->operands[1]);
      }
      output.is_float = type->opcode == spv::OpTypeFloat;
      if (output.is_float) {
        addFloatsOf(output, type->operands[0]);
      }
      outputs_.push_back(output);
    }
  }

  void addFloatsOf(Output& output, std::uint32_t float_type) {
    output.half = module_.constant(float_type, std::bit_cast<std::uint32_t>(0.5F));
    output.ones = module_.constant(float_type, std::bit_cast<std::uint32_t>(1.0F));
    output.zeros = module_.constant(float_type, std::bit_cast<std::uint32_t>(0.0F));
    output.truths = bool_;
    if (output.components > 1) {
      output.truths = module_.type(spv::OpTypeVector, {bool_, output.components});
    }
  }

  [[nodiscard]] std::uint32_t spread(const Output& output, std::uint32_t scalar) {
    if (output.components == 1) {
      return scalar;
    }
    const std::uint32_t vector = module_.newId();
    std::vector<std::uint32_t> operands = {output.type, vector};
    operands.insert(operands.end(), output.components, scalar);
    emit(spv::OpCompositeConstruct, std::move(operands));
    return vector;
  }

  void overturnIfOver() {
    const std::uint32_t total = module_.newId();
    const std::uint32_t is_over = module_.newId();
    const std::uint32_t over = module_.newId();
    const std::uint32_t end = module_.newId();
    emit(spv::OpLoad, {uint_, total, counter_});
    emit(spv::OpUGreaterThan, {bool_, is_over, total, limit_});
    emit(spv::OpSelectionMerge, {end, spv::SelectionControlMaskNone});
    emit(spv::OpBranchConditional, {is_over, over, end});
    emit(spv::OpLabel, {over});
    for (const Output& output : outputs_) {
      overturn(output);
    }
    emit(spv::OpBranch, {end});
    emit(spv::OpLabel, {end});
  }

  void overturn(const Output& output) {
    const std::uint32_t before = module_.newId();
    const std::uint32_t after = module_.newId();
    emit(spv::OpLoad, {output.type, before, output.variable});
    if (output.is_float) {
      const std::uint32_t is_low = module_.newId();
      const std::uint32_t half = spread(output, output.half);
      emit(spv::OpFOrdLessThan, {output.truths, is_low, before, half});
      const std::uint32_t ones = spread(output, output.ones);
      const std::uint32_t zeros = spread(output, output.zeros);
      emit(spv::OpSelect, {output.type, after, is_low, ones, zeros});
    } else {
      emit(spv::OpNot, {output.type, after, before});
    }
    emit(spv::OpStore, {output.variable, after});
  }

  SpirvModule& module_;
  std::uint32_t uint_ = 0;
  std::uint32_t bool_ = 0;
  std::uint32_t one_ = 0;
  std::uint32_t limit_ = 0;
  std::uint32_t counter_ = 0;
  std::uint32_t entry_ = 0;
  std::vector<Output> outputs_;
};

bool isFragment(const SpirvModule& module) {
  return std::ranges::any_of(module.lines(), [](const SpirvLine& line) {
    return line.opcode == spv::OpEntryPoint && line.operands[0] == spv::ExecutionModelFragment;
  });
}

bool hasLoop(const SpirvModule& module) {
  return std::ranges::any_of(module.lines(),
                             [](const SpirvLine& line) { return line.opcode == spv::OpLoopMerge; });
}

}  // namespace

std::vector<std::uint32_t> withCountedLoops(std::span<const std::uint32_t> spirv) {
  SpirvModule module(spirv);
  if (!isFragment(module) || !hasLoop(module)) {
    return {spirv.begin(), spirv.end()};
  }
  LoopCounter(module, kCountedLoopLimit).run();
  return module.words();
}

}  // namespace ssrkit
