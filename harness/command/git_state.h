// What git knows of the kit's own folder.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ssrkit {

// "Name <mail>" as commits of `root` would carry it; none without git or an identity.
[[nodiscard]] std::optional<std::string> gitIdentity(const std::filesystem::path& root);

// The files of `folders` that differ from the last commit, or that no commit has; none where `root` is in no
// repository, as in an unpacked archive.
[[nodiscard]] std::optional<std::vector<std::string>> changedFiles(const std::filesystem::path& root,
                                                                   const std::vector<std::string>& folders);

}  // namespace ssrkit
