#include "shader/glsl_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace ssrkit {

namespace {

bool isNameCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

std::string_view withoutLeadingBlanks(std::string_view text) {
  const auto first = std::find_if_not(text.begin(), text.end(), isBlank);
  return text.substr(static_cast<std::size_t>(first - text.begin()));
}

// End of the comment that starts at `begin`; the newline that ends a line comment is not part of it.
std::size_t commentEnd(std::string_view text, std::size_t begin) {
  if (text[begin + 1] == '*') {
    const std::size_t end = text.find("*/", begin + 2);
    return end == std::string_view::npos ? text.size() : end + 2;
  }
  std::size_t end = text.find('\n', begin);
  while (end != std::string_view::npos && text[end - 1] == '\\') {
    end = text.find('\n', end + 1);
  }
  return std::min(end, text.size());
}

std::optional<std::string> includeName(std::string_view line) {
  std::string_view rest = withoutLeadingBlanks(line);
  if (!rest.starts_with('#')) {
    return std::nullopt;
  }
  rest = withoutLeadingBlanks(rest.substr(1));
  constexpr std::string_view kDirective = "include";
  if (!rest.starts_with(kDirective)) {
    return std::nullopt;
  }
  rest = withoutLeadingBlanks(rest.substr(kDirective.size()));
  if (!rest.starts_with('"') && !rest.starts_with('<')) {
    return std::nullopt;
  }
  const std::size_t close = rest.find(rest.front() == '"' ? '"' : '>', 1);
  if (close == std::string_view::npos) {
    return std::nullopt;
  }
  return std::string(rest.substr(1, close - 1));
}

std::string_view lineOf(std::string_view text, int line) {
  for (int i = 1; i < line; ++i) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) {
      return {};
    }
    text.remove_prefix(end + 1);
  }
  return text.substr(0, text.find('\n'));
}

}  // namespace

std::string blankComments(std::string_view text) {
  std::string code(text);
  std::size_t begin = 0;
  while ((begin = text.find('/', begin)) != std::string_view::npos) {
    if (begin + 1 == text.size() || (text[begin + 1] != '/' && text[begin + 1] != '*')) {
      ++begin;
      continue;
    }
    const std::size_t end = commentEnd(text, begin);
    std::replace_if(
        code.begin() + static_cast<std::ptrdiff_t>(begin), code.begin() + static_cast<std::ptrdiff_t>(end),
        [](char c) { return c != '\n'; }, ' ');
    begin = end;
  }
  return code;
}

std::vector<IncludeLine> findIncludeLines(std::string_view text) {
  const std::string code = blankComments(text);
  std::vector<IncludeLine> includes;
  std::string_view rest = code;
  for (int line = 1; !rest.empty(); ++line) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    if (std::optional<std::string> name = includeName(rest.substr(0, end))) {
      includes.push_back({std::move(*name), line});
    }
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return includes;
}

std::optional<int> findColumn(std::string_view text, int line, std::string_view token) {
  if (token.empty()) {
    return std::nullopt;
  }
  const std::string code = blankComments(text);
  const std::string_view row = lineOf(code, line);
  const bool is_name = isNameCharacter(token.front());
  for (std::size_t at = row.find(token); at != std::string_view::npos; at = row.find(token, at + 1)) {
    const std::size_t after = at + token.size();
    const bool joined_before = is_name && at > 0 && isNameCharacter(row[at - 1]);
    const bool joined_after = is_name && after < row.size() && isNameCharacter(row[after]);
    if (!joined_before && !joined_after) {
      return static_cast<int>(at) + 1;
    }
  }
  return std::nullopt;
}

Expected<std::string> normaliseText(std::string bytes) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (bytes.starts_with(kByteOrderMark)) {
    bytes.erase(0, kByteOrderMark.size());
  }
  const auto is_control = [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < 0x20 && !isBlank(c) && c != '\n' && c != '\r') || byte == 0x7F;
  };
  const auto control = std::find_if(bytes.begin(), bytes.end(), is_control);
  if (control != bytes.end()) {
    return inputError("", fmt::format("byte {} is 0x{:02x}, so it is no GLSL text", control - bytes.begin(),
                                      static_cast<unsigned char>(*control)));
  }
  std::string text;
  text.reserve(bytes.size());
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const bool ends_with_line_feed = bytes[i] == '\r' && i + 1 < bytes.size() && bytes[i + 1] == '\n';
    if (!ends_with_line_feed) {
      text += bytes[i] == '\r' ? '\n' : bytes[i];
    }
  }
  return text;
}

}  // namespace ssrkit
