// Values by name, packed into whatever block a shader declares: reordering a block's members changes nothing.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "base/error.h"
#include "shader/interface.h"

namespace ssrkit {

// A whole number or not, as shaders tell them apart.
using UniformConstant = std::variant<int, double>;

class UniformValues {
 public:
  void set(const std::string& name, double value);
  void set(const std::string& name, int value);
  void set(const std::string& name, glm::dvec2 value);
  void set(const std::string& name, glm::dvec3 value);
  void set(const std::string& name, const glm::dmat4& value);
  void set(const std::string& name, const std::vector<glm::dvec4>& values);

  // Takes a value of `others` under another name. Fails when they have none of the first one.
  [[nodiscard]] Expected<void> alias(const std::string& name, const UniformValues& others,
                                     const std::string& existing);

  // The block's bytes. Fails on a member that has no value here, or another type or size than the shader
  // says; `shader` names the file for the sentence.
  [[nodiscard]] Expected<std::vector<std::byte>> pack(const UniformBlock& block,
                                                      const std::string& shader) const;

 private:
  struct Value {
    ScalarType type = ScalarType::kFloat;
    std::uint32_t rows = 1;
    std::uint32_t columns = 1;
    std::uint32_t count = 0;           // of array elements, 0: no array
    std::vector<std::uint32_t> words;  // 32-bit patterns, tightly packed, column by column
  };
  void setFloats(const std::string& name, std::uint32_t rows, std::uint32_t columns, std::uint32_t count,
                 const double* values);
  std::map<std::string, Value> values_;
};

}  // namespace ssrkit
