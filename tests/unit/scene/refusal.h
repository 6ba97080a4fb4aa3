// A valid glTF file with one mistake, and what its error says.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>

namespace ssrkit::test {

struct Refusal {
  std::string name;
  std::function<void(nlohmann::json&)> spoil;
  std::string expected;  // part of the sentence, place included
};

inline void PrintTo(const Refusal& refusal, std::ostream* out) {
  *out << refusal.name;
}

}  // namespace ssrkit::test
