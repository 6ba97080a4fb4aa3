// The compiler's vocabulary in the words of somebody who writes GLSL.
#pragma once

#include <string>
#include <string_view>

namespace ssrkit {

// "unexpected RIGHT_BRACE" becomes "unexpected '}'", and a type loses the qualifiers that the author never
// wrote.
[[nodiscard]] std::string inWordsOfGlsl(std::string_view message);

// How a token of the grammar is spelled in a file: "=" for "assign". The name itself when it is no such
// token.
[[nodiscard]] std::string_view spellingOf(std::string_view token);

// The spelling of the token that a syntax error names only inside its message; empty when there is none.
[[nodiscard]] std::string_view unexpectedToken(std::string_view message);

}  // namespace ssrkit
