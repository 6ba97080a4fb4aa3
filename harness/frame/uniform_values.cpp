#include "frame/uniform_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <glm/gtc/type_ptr.hpp>

#include "base/check.h"
#include "base/text.h"

namespace ssrkit {

namespace {

// What stands for infinity in a uniform: large enough for every product in the shaders to stay finite, and no
// device has to agree on arithmetic with infinities.
constexpr double kInfinite = 1e30;

std::uint32_t floatBits(double value) {
  return std::bit_cast<std::uint32_t>(static_cast<float>(std::clamp(value, -kInfinite, kInfinite)));
}

}  // namespace

void UniformValues::setFloats(const std::string& name, std::uint32_t rows, std::uint32_t columns,
                              std::uint32_t count, const double* values) {
  Value value{.type = ScalarType::kFloat, .rows = rows, .columns = columns, .count = count, .words = {}};
  const std::size_t scalars = std::size_t{rows} * columns * std::max(count, 1U);
  std::transform(values, values + scalars, std::back_inserter(value.words), floatBits);
  values_[name] = std::move(value);
}

void UniformValues::set(const std::string& name, double value) {
  setFloats(name, 1, 1, 0, &value);
}

void UniformValues::set(const std::string& name, int value) {
  values_[name] = {.type = ScalarType::kInt,
                   .rows = 1,
                   .columns = 1,
                   .count = 0,
                   .words = {static_cast<std::uint32_t>(value)}};
}

void UniformValues::set(const std::string& name, glm::dvec2 value) {
  setFloats(name, 2, 1, 0, glm::value_ptr(value));
}

void UniformValues::set(const std::string& name, glm::dvec3 value) {
  setFloats(name, 3, 1, 0, glm::value_ptr(value));
}

void UniformValues::set(const std::string& name, const glm::dmat4& value) {
  setFloats(name, 4, 4, 0, glm::value_ptr(value));
}

void UniformValues::set(const std::string& name, const std::vector<glm::dvec4>& values) {
  SSRKIT_CHECK(!values.empty());
  setFloats(name, 4, 1, static_cast<std::uint32_t>(values.size()), glm::value_ptr(values.front()));
}

Expected<void> UniformValues::alias(const std::string& name, const UniformValues& others,
                                    const std::string& existing) {
  const auto found = others.values_.find(existing);
  if (found == others.values_.end()) {
    std::vector<std::string> names;
    for (const auto& [known, value] : others.values_) {
      names.push_back(known);
    }
    const auto nearest = nearestName(existing, names);
    return inputError(
        fmt::format("give '{}' a value", name), fmt::format("the kit has no value called '{}'", existing), "",
        nearest ? fmt::format("did you mean '{}'?", *nearest) : "it offers " + joinNames(names));
  }
  values_[name] = found->second;
  return {};
}

Expected<std::vector<std::byte>> UniformValues::pack(const UniformBlock& block,
                                                     const std::string& shader) const {
  std::vector<std::byte> bytes(block.size_bytes);
  for (const BlockMember& member : block.members) {
    const std::string attempted =
        fmt::format("fill the member '{}' of the block '{}'", member.name, block.name);
    const auto found = values_.find(member.name);
    if (found == values_.end()) {
      std::vector<std::string> names;
      for (const auto& [name, value] : values_) {
        names.push_back(name);
      }
      return inputError(attempted, "the kit has no value of that name", shader,
                        "it offers " + joinNames(names));
    }
    const Value& value = found->second;
    if (value.type != member.type || value.rows != member.rows || value.columns != member.columns ||
        value.count != member.array_count) {
      return inputError(
          attempted,
          fmt::format("it is declared with {}x{} components{}, the kit's value has {}x{}{}", member.rows,
                      member.columns, member.array_count > 0 ? fmt::format(" [{}]", member.array_count) : "",
                      value.rows, value.columns, value.count > 0 ? fmt::format(" [{}]", value.count) : ""),
          shader, "declare it as the kit's own shaders do");
    }
    const std::size_t column_bytes = value.rows * sizeof(std::uint32_t);
    for (std::size_t element = 0; element < std::max(value.count, 1U); ++element) {
      for (std::size_t column = 0; column < value.columns; ++column) {
        const std::size_t offset =
            member.offset_bytes + element * member.array_stride_bytes + column * member.matrix_stride_bytes;
        const std::size_t first_word = (element * value.columns + column) * value.rows;
        SSRKIT_CHECK_LE(offset + column_bytes, bytes.size());
        std::memcpy(bytes.data() + offset, value.words.data() + first_word, column_bytes);
      }
    }
  }
  return bytes;
}

}  // namespace ssrkit
