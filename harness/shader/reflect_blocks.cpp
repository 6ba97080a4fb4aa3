#include "shader/reflect_blocks.h"

#include <fmt/format.h>

#include "shader/reflect_error.h"

namespace ssrkit {

namespace {

// Flattening turns each element of an array of structs into members; nobody reads more than this.
constexpr std::size_t kMemberLimit = 4096;

class BlockReader {
 public:
  explicit BlockReader(const spirv_cross::Compiler& compiler) : compiler_(compiler) {}

  void addMembers(const spirv_cross::SPIRType& type, const std::string& prefix, std::uint32_t base_bytes) {
    for (std::uint32_t i = 0; i < type.member_types.size(); ++i) {
      const std::string name = prefix + compiler_.get_member_name(type.self, i);
      const spirv_cross::SPIRType& member = compiler_.get_type(type.member_types[i]);
      const std::uint32_t offset = base_bytes + compiler_.type_struct_member_offset(type, i);
      const std::uint32_t count = arrayCount(compiler_, member, name);
      const std::uint32_t stride = count == 0 ? 0 : compiler_.type_struct_member_array_stride(type, i);
      if (member.basetype == spirv_cross::SPIRType::Struct) {
        addStruct(member, name, offset, count, stride);
      } else {
        addValue(
            type, i,
            {name, scalarTypeOf(member, name), offset, member.vecsize, member.columns, 0, count, stride});
      }
    }
  }

  [[nodiscard]] std::vector<BlockMember> take() { return std::move(members_); }

 private:
  void addStruct(const spirv_cross::SPIRType& type, const std::string& name, std::uint32_t offset,
                 std::uint32_t count, std::uint32_t stride) {
    // The type of an array of structs holds the decorations at its element's type.
    const spirv_cross::SPIRType& element = count == 0 ? type : compiler_.get_type(type.parent_type);
    if (count == 0) {
      addMembers(element, name + ".", offset);
    }
    for (std::uint32_t i = 0; i < count; ++i) {
      addMembers(element, fmt::format("{}[{}].", name, i), offset + i * stride);
    }
  }

  void addValue(const spirv_cross::SPIRType& type, std::uint32_t index, BlockMember member) {
    if (members_.size() >= kMemberLimit) {
      throw UnsupportedInterface(fmt::format("a uniform block has more than {} members", kMemberLimit));
    }
    if (member.columns > 1) {
      if (compiler_.has_member_decoration(type.self, index, spv::DecorationRowMajor)) {
        throw UnsupportedInterface(
            fmt::format("the matrix '{}' is row_major; the kit's matrices are column-major", member.name));
      }
      member.matrix_stride_bytes = compiler_.type_struct_member_matrix_stride(type, index);
    }
    members_.push_back(std::move(member));
  }

  const spirv_cross::Compiler& compiler_;
  std::vector<BlockMember> members_;
};

}  // namespace

ScalarType scalarTypeOf(const spirv_cross::SPIRType& type, const std::string& name) {
  switch (type.basetype) {
    case spirv_cross::SPIRType::Float:
      return ScalarType::kFloat;
    case spirv_cross::SPIRType::Int:
      return ScalarType::kInt;
    case spirv_cross::SPIRType::UInt:
    case spirv_cross::SPIRType::Boolean:
      return ScalarType::kUint;
    default:
      throw UnsupportedInterface(fmt::format(
          "'{}' is neither float, int, uint nor bool of 32 bits, and a pass cannot feed it", name));
  }
}

std::uint32_t arrayCount(const spirv_cross::Compiler& compiler, const spirv_cross::SPIRType& type,
                         const std::string& name) {
  if (type.array.empty()) {
    return 0;
  }
  if (type.array.size() > 1) {
    throw UnsupportedInterface(fmt::format("'{}' is an array of arrays; use one index", name));
  }
  const std::uint32_t size = type.array.front();
  return type.array_size_literal.front() ? size : compiler.get_constant(size).scalar();
}

UniformBlock reflectBlock(const spirv_cross::Compiler& compiler, const spirv_cross::Resource& resource) {
  const spirv_cross::SPIRType& type = compiler.get_type(resource.base_type_id);
  UniformBlock block;
  block.name = resource.name;
  block.binding = compiler.get_decoration(resource.id, spv::DecorationBinding);
  // A std140 block ends on a vec4, and GL wants a buffer of that size (OpenGL 4.5, section 7.6.2.2).
  constexpr std::size_t kAlignmentBytes = 16;
  const std::size_t declared_bytes = compiler.get_declared_struct_size(type);
  block.size_bytes =
      static_cast<std::uint32_t>((declared_bytes + kAlignmentBytes - 1) / kAlignmentBytes * kAlignmentBytes);
  if (!compiler.get_type(resource.type_id).array.empty()) {
    throw UnsupportedInterface(fmt::format("'{}' is an array of blocks; use one block", block.name));
  }
  BlockReader reader(compiler);
  reader.addMembers(type, "", 0);
  block.members = reader.take();
  return block;
}

}  // namespace ssrkit
