#include "scene/gltf_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "scene/clean_name.h"

namespace ssrkit {

namespace {

constexpr std::size_t kMaxTextBytes = std::size_t{512} << 20;
constexpr std::size_t kMaxValues = 8'000'000;
constexpr int kMaxDepth = 64;

// "12:7" of the byte at `offset`.
std::string lineAndColumn(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const std::size_t last_break = before.rfind('\n');
  const std::size_t column =
      last_break == std::string_view::npos ? before.size() + 1 : before.size() - last_break;
  return fmt::format("{}:{}", line, column);
}

tl::unexpected<Error> refuseAt(const GltfSource& source, std::string_view text, std::size_t offset,
                               std::string problem) {
  return inputError("load the scene", std::move(problem),
                    source.file.string() + ":" + lineAndColumn(text, offset));
}

// Nesting and the number of values, without building anything.
Expected<void> checkExtent(const GltfSource& source, std::string_view text) {
  int depth = 0;
  std::size_t values = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      i += c == '\\' ? 1U : 0U;
      in_string = c != '"';
      continue;
    }
    in_string = c == '"';
    values += c == ',' ? 1U : 0U;
    depth += static_cast<int>(c == '{' || c == '[') - static_cast<int>(c == '}' || c == ']');
    if (depth > kMaxDepth) {
      return refuseAt(source, text, i, fmt::format("the JSON is nested deeper than {} levels", kMaxDepth));
    }
    if (values > kMaxValues) {
      return refuseAt(source, text, i, fmt::format("the JSON has more than {} values", kMaxValues));
    }
  }
  return {};
}

// nlohmann's message without its own prefix and place, which the error states already.
std::string reasonOf(const nlohmann::json::exception& exception) {
  const std::string_view message = exception.what();
  const std::size_t syntax = message.find("syntax error");
  const std::size_t bracket = message.find("] ");
  const std::size_t first = syntax != std::string_view::npos    ? syntax
                            : bracket == std::string_view::npos ? 0
                                                                : bracket + 2;
  std::string reason = cleanName(message.substr(first));
  // It quotes the file, which may hold bytes that are no text.
  std::ranges::replace_if(
      reason, [](char letter) { return letter < ' ' || letter > '~'; }, '?');
  return reason;
}

}  // namespace

Expected<nlohmann::json> parseGltfJson(const GltfSource& source, const std::string& text) {
  if (text.size() > kMaxTextBytes) {
    return source.refuse(
        "",
        fmt::format("its JSON has {} MiB and the limit is {} MiB", text.size() >> 20U, kMaxTextBytes >> 20U),
        "keep its buffers in a .bin file beside it");
  }
  if (auto extent = checkExtent(source, text); !extent) {
    return tl::make_unexpected(extent.error());
  }
  try {
    nlohmann::json root = nlohmann::json::parse(text);
    if (!root.is_object()) {
      return refuseAt(source, text, 0, "its JSON is not an object");
    }
    return root;
  } catch (const nlohmann::json::parse_error& error) {
    return refuseAt(source, text, error.byte == 0 ? 0 : error.byte - 1, "its JSON has a " + reasonOf(error));
  } catch (const nlohmann::json::exception& error) {
    return source.refuse("", "its JSON cannot be read: " + reasonOf(error));
  }
}

}  // namespace ssrkit
