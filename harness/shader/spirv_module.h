// A SPIR-V module taken apart into instructions that can be changed, added and put together again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace ssrkit {

// One instruction: its opcode and the words after the first.
struct SpirvLine {
  std::uint32_t opcode = 0;
  std::vector<std::uint32_t> operands;
};

class SpirvModule {
 public:
  // The words must be a whole module, as a compiler emits it.
  explicit SpirvModule(std::span<const std::uint32_t> words);
  [[nodiscard]] std::vector<std::uint32_t> words() const;

  [[nodiscard]] std::vector<SpirvLine>& lines() { return lines_; }
  [[nodiscard]] const std::vector<SpirvLine>& lines() const { return lines_; }
  [[nodiscard]] std::uint32_t newId() { return bound_++; }

  // The id of the type or constant that this instruction declares, made anew behind all others when there is
  // none. `operands` are those after the result's id (and, for a constant, its type).
  [[nodiscard]] std::uint32_t type(std::uint32_t opcode, const std::vector<std::uint32_t>& operands);
  [[nodiscard]] std::uint32_t constant(std::uint32_t type_id, std::uint32_t bits);

  // The line that declares an id as a type or a constant; null for any other id.
  [[nodiscard]] const SpirvLine* declarationOf(std::uint32_t id) const;

  // The literal of `decoration` on an id, or on a member of a structure.
  [[nodiscard]] std::optional<std::uint32_t> decoration(std::uint32_t id, std::uint32_t decoration) const;
  [[nodiscard]] std::optional<std::uint32_t> decoration(std::uint32_t struct_id, std::uint32_t member,
                                                        std::uint32_t decoration) const;

 private:
  [[nodiscard]] std::size_t firstFunction() const;

  std::vector<std::uint32_t> header_;
  std::vector<SpirvLine> lines_;
  std::uint32_t bound_ = 0;
};

// The module's uniform block: a pass has at most one, and each stage declares it on its own.
struct UniformBlockIds {
  std::uint32_t variable = 0;
  std::uint32_t structure = 0;
};
[[nodiscard]] std::optional<UniformBlockIds> uniformBlockOf(const SpirvModule& module);

// Bytes that a member of a std140 block takes, and the multiple of bytes that it may start at.
struct MemberExtent {
  std::uint32_t size_bytes = 0;
  std::uint32_t alignment_bytes = 0;
};
[[nodiscard]] MemberExtent extentOf(const SpirvModule& module, std::uint32_t struct_id, std::uint32_t member);

}  // namespace ssrkit
