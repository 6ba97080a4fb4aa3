// What can go wrong in the world outside the program: drivers, files, compilers, users.
// Programmer errors are checks (base/check.h); a failed expectation is a test outcome (check/outcome.h).
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace ssrkit {

// Who can mend it, which decides the exit code.
enum class ErrorKind {
  kInput,  // wrong usage or a bad input file: exit 2
  kSetup,  // no driver, disk full, missing permission: exit 3
};

struct Error {
  ErrorKind kind = ErrorKind::kInput;
  std::string attempted;             // "load the scene 'a.gltf'"
  std::string problem;               // "accessor 3 reads 96 bytes past its buffer view"
  std::string where;                 // "a.gltf:12:7", empty when there is no place
  std::string remedy;                // "export the file again", empty when nobody knows
  std::vector<std::string> reasons;  // every native message and code, most important first
};

template <class T>
using Expected = tl::expected<T, Error>;

// An error of the user's making (exit 2).
[[nodiscard]] tl::unexpected<Error> inputError(std::string attempted, std::string problem,
                                               std::string where = {}, std::string remedy = {});

// An error of the machine's set-up (exit 3).
[[nodiscard]] tl::unexpected<Error> setupError(std::string attempted, std::string problem,
                                               std::string where = {}, std::string remedy = {});

// The whole error as one sentence on one line, "where: could not ATTEMPTED: PROBLEM; REMEDY." and the
// reasons on indented lines below it.
[[nodiscard]] std::string sentence(const Error& error);

// 2 for kInput, 3 for kSetup.
[[nodiscard]] int exitCode(const Error& error);

}  // namespace ssrkit
