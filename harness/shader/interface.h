// What a SPIR-V module reads and writes, from reflection: C++ never repeats a binding number.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ssrkit {

enum class SamplerKind { kFloat, kInt, kUint };

struct SamplerBinding {
  std::string name;
  std::uint32_t binding = 0;
  SamplerKind kind = SamplerKind::kFloat;
};

enum class ScalarType { kFloat, kInt, kUint };

struct BlockMember {
  std::string name;
  ScalarType type = ScalarType::kFloat;
  std::uint32_t offset_bytes = 0;
  std::uint32_t rows = 1;     // vector size, or rows of a matrix
  std::uint32_t columns = 1;  // > 1: a column-major matrix with matrix_stride_bytes between columns
  std::uint32_t matrix_stride_bytes = 0;
  std::uint32_t array_count = 0;  // 0: no array
  std::uint32_t array_stride_bytes = 0;
};

struct UniformBlock {
  std::string name;
  std::uint32_t binding = 0;
  std::uint32_t size_bytes = 0;  // a multiple of 16
  std::vector<BlockMember> members;
};

struct StageVariable {
  std::string name;
  std::uint32_t location = 0;
  ScalarType type = ScalarType::kFloat;
  std::uint32_t components = 4;
};

struct SpecConstantInfo {
  std::string name;
  std::uint32_t id = 0;
  ScalarType type = ScalarType::kInt;
  std::uint32_t default_bits = 0;
};

struct ShaderInterface {
  std::vector<SamplerBinding> samplers;
  std::vector<UniformBlock> uniform_blocks;
  std::vector<StageVariable> inputs;
  std::vector<StageVariable> outputs;
  std::vector<SpecConstantInfo> spec_constants;
};

}  // namespace ssrkit
