#include "base/error.h"

#include <fmt/format.h>

#include <utility>

namespace ssrkit {

namespace {

tl::unexpected<Error> make(ErrorKind kind, std::string attempted, std::string problem, std::string where,
                           std::string remedy) {
  return tl::make_unexpected(
      Error{kind, std::move(attempted), std::move(problem), std::move(where), std::move(remedy), {}});
}

}  // namespace

tl::unexpected<Error> inputError(std::string attempted, std::string problem, std::string where,
                                 std::string remedy) {
  return make(ErrorKind::kInput, std::move(attempted), std::move(problem), std::move(where),
              std::move(remedy));
}

tl::unexpected<Error> setupError(std::string attempted, std::string problem, std::string where,
                                 std::string remedy) {
  return make(ErrorKind::kSetup, std::move(attempted), std::move(problem), std::move(where),
              std::move(remedy));
}

std::string sentence(const Error& error) {
  std::string text = error.where.empty() ? "" : error.where + ": ";
  text += fmt::format("could not {}: {}", error.attempted, error.problem);
  if (!error.remedy.empty()) {
    text += "; " + error.remedy;
  }
  for (const std::string& reason : error.reasons) {
    text += "\n  " + reason;
  }
  return text;
}

int exitCode(const Error& error) {
  return error.kind == ErrorKind::kInput ? 2 : 3;
}

}  // namespace ssrkit
