#include "mutation/text_edit.h"

#include <fmt/format.h>

namespace ssrkit {

namespace {

std::size_t countOf(std::string_view content, std::string_view text) {
  std::size_t count = 0;
  for (std::size_t at = content.find(text); at != std::string_view::npos; at = content.find(text, at + 1)) {
    ++count;
  }
  return count;
}

}  // namespace

Expected<std::string> applyEdit(std::string_view content, const TextEdit& edit, const std::string& where) {
  const std::string attempted = fmt::format("edit '{}'", edit.file.string());
  const std::size_t count = edit.replace.empty() ? 0 : countOf(content, edit.replace);
  if (count != 1) {
    return inputError(attempted, fmt::format("the text to replace stands there {} times", count), where,
                      count == 0 ? "take it from the file as it is now" : "add to it what stands around it");
  }
  std::string edited(content);
  edited.replace(edited.find(edit.replace), edit.replace.size(), edit.with);
  return edited;
}

}  // namespace ssrkit
