#include "shader/glsl_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

namespace ssrkit {

namespace {

struct Word {
  std::string_view compiler;
  std::string_view people;
};

constexpr std::array kTokens = {
    Word{"LEFT_PAREN", "("},   Word{"RIGHT_PAREN", ")"},   Word{"LEFT_BRACE", "{"},  Word{"RIGHT_BRACE", "}"},
    Word{"LEFT_BRACKET", "["}, Word{"RIGHT_BRACKET", "]"}, Word{"LEFT_ANGLE", "<"},  Word{"RIGHT_ANGLE", ">"},
    Word{"SEMICOLON", ";"},    Word{"COMMA", ","},         Word{"COLON", ":"},       Word{"DOT", "."},
    Word{"EQUAL", "="},        Word{"BANG", "!"},          Word{"DASH", "-"},        Word{"PLUS", "+"},
    Word{"STAR", "*"},         Word{"SLASH", "/"},         Word{"PERCENT", "%"},     Word{"QUESTION", "?"},
    Word{"AMPERSAND", "&"},    Word{"VERTICAL_BAR", "|"},  Word{"CARET", "^"},       Word{"TILDE", "~"},
    Word{"EQ_OP", "=="},       Word{"NE_OP", "!="},        Word{"LE_OP", "<="},      Word{"GE_OP", ">="},
    Word{"AND_OP", "&&"},      Word{"OR_OP", "||"},        Word{"INC_OP", "++"},     Word{"DEC_OP", "--"},
    Word{"ADD_ASSIGN", "+="},  Word{"SUB_ASSIGN", "-="},   Word{"MUL_ASSIGN", "*="}, Word{"DIV_ASSIGN", "/="},
    Word{"LEFT_OP", "<<"},     Word{"RIGHT_OP", ">>"},     Word{"assign", "="},
};

constexpr std::array kPhrases = {
    Word{"IDENTIFIER", "a name"},
    Word{"INTCONSTANT", "a whole number"},
    Word{"FLOATCONSTANT", "a number"},
    Word{"' const ", "'const "},
    Word{"' temp ", "'"},
    Word{"highp ", ""},
    Word{"memory exhausted", "it is nested deeper than the compiler can follow"},
    Word{"Linking fragment stage: Missing entry point: Each stage requires one entry point",
         "there is no 'void main()' in it"},
    Word{"Linking vertex stage: Missing entry point: Each stage requires one entry point",
         "there is no 'void main()' in it"},
};

void replaceAll(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

std::optional<std::string_view> spelling(std::string_view word) {
  const auto found = std::ranges::find(kTokens, word, &Word::compiler);
  return found == kTokens.end() ? std::nullopt : std::optional(found->people);
}

// "'layout( location=0) out vec4'" is shown as "'out vec4'".
void dropLayouts(std::string& text) {
  constexpr std::string_view kLayout = "'layout(";
  for (std::size_t at = text.find(kLayout); at != std::string::npos; at = text.find(kLayout, at + 1)) {
    const std::size_t end = text.find(") ", at);
    if (end == std::string::npos) {
      return;
    }
    text.erase(at + 1, end + 1 - at);
  }
}

}  // namespace

std::string inWordsOfGlsl(std::string_view message) {
  std::string result;
  std::size_t begin = 0;
  while (begin < message.size()) {
    const std::size_t end = std::min(message.find_first_of(" ,", begin), message.size());
    const std::string_view word = message.substr(begin, end - begin);
    const std::optional<std::string_view> spelled = spelling(word);
    result += spelled ? fmt::format("'{}'", *spelled) : std::string(word);
    result += message.substr(end, end < message.size() ? 1 : 0);
    begin = end + 1;
  }
  for (const Word& phrase : kPhrases) {
    replaceAll(result, phrase.compiler, phrase.people);
  }
  dropLayouts(result);
  return result;
}

std::string_view spellingOf(std::string_view token) {
  return spelling(token).value_or(token);
}

std::string_view unexpectedToken(std::string_view message) {
  constexpr std::string_view kUnexpected = "unexpected ";
  const std::size_t at = message.find(kUnexpected);
  if (at == std::string_view::npos) {
    return {};
  }
  const std::string_view rest = message.substr(at + kUnexpected.size());
  return spelling(rest.substr(0, rest.find_first_of(" ,"))).value_or(std::string_view());
}

}  // namespace ssrkit
