#include "shader/diagnostics.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <utility>

#include "base/text.h"
#include "shader/glsl_text.h"

namespace ssrkit {

namespace {

constexpr std::size_t kReasonLimit = 20;

struct Diagnostic {
  std::string where;
  std::string message;
};

struct TokenSpelling {
  std::string_view token;
  std::string_view spelling;
};

// The parser names tokens by its grammar; people know them by their characters.
constexpr std::array kSpellings = {
    TokenSpelling{"LEFT_PAREN", "("},   TokenSpelling{"RIGHT_PAREN", ")"},
    TokenSpelling{"LEFT_BRACE", "{"},   TokenSpelling{"RIGHT_BRACE", "}"},
    TokenSpelling{"LEFT_BRACKET", "["}, TokenSpelling{"RIGHT_BRACKET", "]"},
    TokenSpelling{"LEFT_ANGLE", "<"},   TokenSpelling{"RIGHT_ANGLE", ">"},
    TokenSpelling{"SEMICOLON", ";"},    TokenSpelling{"COMMA", ","},
    TokenSpelling{"COLON", ":"},        TokenSpelling{"DOT", "."},
    TokenSpelling{"EQUAL", "="},        TokenSpelling{"BANG", "!"},
    TokenSpelling{"DASH", "-"},         TokenSpelling{"PLUS", "+"},
    TokenSpelling{"STAR", "*"},         TokenSpelling{"SLASH", "/"},
    TokenSpelling{"PERCENT", "%"},      TokenSpelling{"QUESTION", "?"},
    TokenSpelling{"AMPERSAND", "&"},    TokenSpelling{"VERTICAL_BAR", "|"},
    TokenSpelling{"CARET", "^"},        TokenSpelling{"TILDE", "~"},
    TokenSpelling{"EQ_OP", "=="},       TokenSpelling{"NE_OP", "!="},
    TokenSpelling{"LE_OP", "<="},       TokenSpelling{"GE_OP", ">="},
    TokenSpelling{"AND_OP", "&&"},      TokenSpelling{"OR_OP", "||"},
    TokenSpelling{"INC_OP", "++"},      TokenSpelling{"DEC_OP", "--"},
    TokenSpelling{"ADD_ASSIGN", "+="},  TokenSpelling{"SUB_ASSIGN", "-="},
    TokenSpelling{"MUL_ASSIGN", "*="},  TokenSpelling{"DIV_ASSIGN", "/="},
    TokenSpelling{"LEFT_OP", "<<"},     TokenSpelling{"RIGHT_OP", ">>"},
};

void replaceAll(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  const std::size_t last = text.find_last_not_of(" \t");
  return first == std::string_view::npos ? std::string_view() : text.substr(first, last - first + 1);
}

std::optional<std::string_view> spellingOf(std::string_view word) {
  const auto found = std::find_if(kSpellings.begin(), kSpellings.end(),
                                  [word](const TokenSpelling& entry) { return entry.token == word; });
  return found == kSpellings.end() ? std::nullopt : std::optional(found->spelling);
}

// The whole words of the grammar, replaced by what stands in the file.
std::string inWordsOfGlsl(std::string_view message) {
  std::string result;
  std::size_t begin = 0;
  while (begin < message.size()) {
    const std::size_t end = std::min(message.find_first_of(" ,", begin), message.size());
    const std::string_view word = message.substr(begin, end - begin);
    const std::optional<std::string_view> spelling = spellingOf(word);
    result += spelling ? fmt::format("'{}'", *spelling) : std::string(word);
    result += message.substr(end, end < message.size() ? 1 : 0);
    begin = end + 1;
  }
  replaceAll(result, "IDENTIFIER", "a name");
  replaceAll(result, "INTCONSTANT", "a whole number");
  replaceAll(result, "FLOATCONSTANT", "a number");
  replaceAll(result, "' const ", "'const ");
  replaceAll(result, "' temp ", "'");
  return result;
}

// The token that a syntax error names only inside its message.
std::string_view unexpectedToken(std::string_view message) {
  constexpr std::string_view kUnexpected = "unexpected ";
  const std::size_t at = message.find(kUnexpected);
  if (at == std::string_view::npos) {
    return {};
  }
  const std::string_view rest = message.substr(at + kUnexpected.size());
  return spellingOf(rest.substr(0, rest.find_first_of(" ,"))).value_or(std::string_view());
}

Diagnostic describe(std::string_view message, const SourceTree& tree, std::size_t file, int line) {
  std::string_view token;
  constexpr std::string_view kSeparator = "' : ";
  const std::size_t token_end = message.find(kSeparator);
  if (message.starts_with('\'') && token_end != std::string_view::npos) {
    token = message.substr(1, std::max<std::size_t>(token_end, 1) - 1);
    message = trimmed(message.substr(token_end + kSeparator.size()));
  }
  if (token == "#include") {
    message = message.substr(0, message.rfind(" for header name: "));
  }
  const std::string_view sought = token.empty() ? unexpectedToken(message) : token;
  const std::optional<int> column = findColumn(tree.files[file].text, line, sought);
  std::string where = placeInTree(tree, file, line) + (column ? fmt::format(":{}", *column) : "");
  std::string words = inWordsOfGlsl(message);
  return {std::move(where), token.empty() ? std::move(words) : fmt::format("'{}': {}", token, words)};
}

// "s0:12: ..." with the rest of the line; nothing for a message about the whole shader.
std::optional<Diagnostic> placedDiagnostic(std::string_view line_of_log, const SourceTree& tree) {
  const std::size_t name_end = line_of_log.find(':');
  const std::size_t number_end =
      name_end == std::string_view::npos ? name_end : line_of_log.find(':', name_end + 1);
  if (number_end == std::string_view::npos) {
    return std::nullopt;
  }
  int line = 0;
  const char* const end = line_of_log.data() + number_end;
  const auto [stopped_at, code] = std::from_chars(line_of_log.data() + name_end + 1, end, line);
  if (code != std::errc() || stopped_at != end) {
    return std::nullopt;
  }
  const std::string_view name = line_of_log.substr(0, name_end);
  const std::string_view message = trimmed(line_of_log.substr(number_end + 1));
  const std::optional<std::size_t> file = fileIndex(name);
  if (!file || *file >= tree.files.size()) {  // the author's own #line
    return Diagnostic{fmt::format("{}:{}", name, line), inWordsOfGlsl(message)};
  }
  return describe(message, tree, *file, line);
}

std::vector<Diagnostic> parseLog(std::string_view log, const SourceTree& tree) {
  constexpr std::string_view kError = "ERROR: ";
  std::vector<Diagnostic> diagnostics;
  for (const std::string& line : split(log, '\n')) {
    if (!line.starts_with(kError) || line.find("compilation errors.") != std::string::npos) {
      continue;
    }
    const std::string_view rest = std::string_view(line).substr(kError.size());
    std::optional<Diagnostic> placed = placedDiagnostic(rest, tree);
    diagnostics.push_back(placed ? std::move(*placed)
                                 : Diagnostic{tree.files.front().shown_path, std::string(trimmed(rest))});
  }
  return diagnostics;
}

}  // namespace

std::string neutralName(std::size_t file_index) {
  return fmt::format("s{}", file_index);
}

std::optional<std::size_t> fileIndex(std::string_view neutral_name) {
  std::size_t index = 0;
  const char* const end = neutral_name.data() + neutral_name.size();
  if (!neutral_name.starts_with('s')) {
    return std::nullopt;
  }
  const auto [stopped_at, code] = std::from_chars(neutral_name.data() + 1, end, index);
  return code == std::errc() && stopped_at == end ? std::optional(index) : std::nullopt;
}

std::string placeInTree(const SourceTree& tree, std::size_t file_index, int line) {
  return fmt::format("{}:{}", tree.files[file_index].shown_path, line);
}

Error errorFromLog(std::string_view log, const SourceTree& tree, const std::string& attempted) {
  const std::vector<Diagnostic> diagnostics = parseLog(log, tree);
  Error error{ErrorKind::kInput, attempted, "the compiler refused it without a reason", {}, {}, {}};
  error.where = tree.files.front().shown_path;
  if (diagnostics.empty()) {
    return error;
  }
  error.where = diagnostics.front().where;
  error.problem = diagnostics.front().message;
  for (std::size_t i = 0; i < std::min(diagnostics.size(), kReasonLimit); ++i) {
    error.reasons.push_back(fmt::format("{}: {}", diagnostics[i].where, diagnostics[i].message));
  }
  if (diagnostics.size() > kReasonLimit) {
    error.reasons.push_back(fmt::format("and {} more", diagnostics.size() - kReasonLimit));
  }
  return error;
}

}  // namespace ssrkit
