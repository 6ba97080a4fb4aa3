#include "shader/diagnostics.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include "base/text.h"
#include "shader/glsl_text.h"
#include "shader/glsl_words.h"

namespace ssrkit {

namespace {

constexpr std::size_t kDiagnosticLimit = 20;  // nobody reads on, and a hostile file has thousands

struct Diagnostic {
  std::string line;   // "file:line"
  std::string where;  // with the column, when it is known
  std::string message;
};

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  const std::size_t last = text.find_last_not_of(" \t");
  return first == std::string_view::npos ? std::string_view() : text.substr(first, last - first + 1);
}

Diagnostic describe(std::string_view message, const SourceTree& tree, std::size_t file, int line) {
  std::string_view token;
  constexpr std::string_view kSeparator = "' : ";
  const std::size_t token_end = message.find(kSeparator);
  if (message.starts_with('\'') && token_end != std::string_view::npos) {
    token = spellingOf(message.substr(1, std::max<std::size_t>(token_end, 1) - 1));
    message = trimmed(message.substr(token_end + kSeparator.size()));
  }
  if (token == "#include") {
    message = message.substr(0, message.rfind(" for header name: "));
  }
  const std::string_view sought = token.empty() ? unexpectedToken(message) : token;
  const std::optional<int> column = findColumn(tree.files[file].text, line, sought);
  std::string place = placeInTree(tree, file, line);
  std::string where = place + (column ? fmt::format(":{}", *column) : "");
  std::string words = inWordsOfGlsl(message);
  return {std::move(place), std::move(where),
          token.empty() ? std::move(words) : fmt::format("'{}': {}", token, words)};
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
    const std::string place = fmt::format("{}:{}", name, line);
    return Diagnostic{place, place, inWordsOfGlsl(message)};
  }
  return describe(message, tree, *file, line);
}

std::vector<Diagnostic> parseLog(std::string_view log, const SourceTree& tree) {
  constexpr std::string_view kError = "ERROR: ";
  std::vector<Diagnostic> diagnostics;
  for (const std::string& line : split(log, '\n')) {
    if (diagnostics.size() == kDiagnosticLimit) {
      break;
    }
    if (!line.starts_with(kError) || line.find("compilation errors.") != std::string::npos) {
      continue;
    }
    const std::string_view rest = std::string_view(line).substr(kError.size());
    std::optional<Diagnostic> placed = placedDiagnostic(rest, tree);
    const std::string& entry = tree.files.front().shown_path;
    Diagnostic diagnostic = placed ? std::move(*placed) : Diagnostic{"", entry, inWordsOfGlsl(trimmed(rest))};
    // What follows on the same line is nearly always a consequence.
    if (diagnostics.empty() || diagnostic.line.empty() || diagnostics.back().line != diagnostic.line) {
      diagnostics.push_back(std::move(diagnostic));
    }
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
  for (const Diagnostic& diagnostic : diagnostics) {
    error.reasons.push_back(fmt::format("{}: {}", diagnostic.where, diagnostic.message));
  }
  return error;
}

}  // namespace ssrkit
