#pragma once

#include <string>
#include <string_view>

#include "base/error.h"
#include "mutation/mutant.h"

namespace ssrkit {

// `content` with the edit made. Fails unless its text stands there exactly once: an edit that fits nowhere
// has been outrun by its file, one that fits twice does not say which place it means. `where` is for the
// message.
[[nodiscard]] Expected<std::string> applyEdit(std::string_view content, const TextEdit& edit,
                                              const std::string& where);

}  // namespace ssrkit
