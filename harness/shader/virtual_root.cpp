#include "shader/virtual_root.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <system_error>

#include "base/text.h"
#include "shader/source_tree.h"

namespace ssrkit {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kNameLimitBytes = 255;

bool climbs(const fs::path& path) {
  return std::any_of(path.begin(), path.end(), [](const fs::path& part) { return part == ".."; });
}

// A FIFO or a device would block or never end.
std::string whyNotAFile(const fs::path& path) {
  std::error_code code;
  const fs::file_status status = fs::status(path, code);
  if (status.type() == fs::file_type::not_found) {
    return "there is no such file";
  }
  if (status.type() == fs::file_type::directory) {
    return "it is a folder";
  }
  if (status.type() != fs::file_type::regular) {
    return code ? code.message() : "it is no regular file";
  }
  return {};
}

std::vector<std::string> fileNames(const fs::path& folder) {
  constexpr std::size_t kEnough = 1000;
  std::vector<std::string> names;
  std::error_code code;
  for (fs::directory_iterator it(folder, code), end; !code && it != end && names.size() < kEnough;
       it.increment(code)) {
    names.push_back(it->path().filename().string());
  }
  return names;
}

}  // namespace

Expected<VirtualRoot> VirtualRoot::open(const ShaderSource& source, const std::string& attempted) {
  VirtualRoot result;
  if (!source.root.empty()) {
    std::error_code code;
    const fs::path root = fs::canonical(source.root, code);
    if (code || !fs::is_directory(root, code)) {
      return inputError(attempted, fmt::format("the shader folder '{}' is not there", source.root.string()));
    }
    result.roots_.push_back(root);
    result.include_folder_ = root / "include";
  }
  if (const Expected<void> opened = result.openEntry(source, attempted); !opened) {
    return tl::make_unexpected(opened.error());
  }
  return result;
}

Expected<void> VirtualRoot::openEntry(const ShaderSource& source, const std::string& attempted) {
  std::error_code code;
  if (source.entry.is_absolute()) {
    const std::string why = whyNotAFile(source.entry);
    if (!why.empty()) {
      return inputError(attempted, why, shownPath(source.entry));
    }
    // The user named this file, so a link is followed; its includes are looked up where the link stands.
    const fs::path folder = fs::canonical(source.entry.parent_path(), code);
    entry_ = folder / source.entry.filename();
    roots_.push_back(folder);
    return {};
  }
  if (roots_.empty() || source.entry.empty() || climbs(source.entry)) {
    return inputError(attempted,
                      fmt::format("'{}' is no path inside the shader folder", source.entry.string()));
  }
  const fs::path path = roots_.front() / source.entry;
  const std::string why = whyNotAFile(path);
  if (!why.empty()) {
    return inputError(attempted, why, shownPath(path));
  }
  entry_ = fs::canonical(path, code);
  if (!contains(entry_)) {
    return inputError(attempted, "a symbolic link leads out of the shader folder", shownPath(path));
  }
  return {};
}

bool VirtualRoot::contains(const fs::path& canonical) const {
  return std::any_of(roots_.begin(), roots_.end(), [&canonical](const fs::path& root) {
    return std::mismatch(root.begin(), root.end(), canonical.begin(), canonical.end()).first == root.end();
  });
}

std::string VirtualRoot::missingMessage(const std::string& name, const fs::path& including_folder) const {
  std::vector<std::string> known = fileNames(including_folder);
  std::string message = fmt::format("there is no '{}' beside the file", name);
  if (!include_folder_.empty()) {
    message += fmt::format(" nor in '{}'", shownPath(include_folder_));
    const std::vector<std::string> more = fileNames(include_folder_);
    known.insert(known.end(), more.begin(), more.end());
  }
  if (const std::optional<std::string> near = nearestName(name, known)) {
    message += fmt::format("; did you mean '{}'?", *near);
  }
  return message;
}

Expected<fs::path> VirtualRoot::resolve(const std::string& name, const fs::path& including_folder) const {
  const fs::path relative(name);
  if (relative.empty()) {
    return inputError("", "the name is empty");
  }
  if (name.size() > kNameLimitBytes) {
    return inputError("", fmt::format("the name is longer than {} bytes", kNameLimitBytes));
  }
  if (relative.is_absolute()) {
    return inputError("", fmt::format("'{}' is an absolute path; name a file relative to this one", name));
  }
  if (climbs(relative)) {
    return inputError("", fmt::format("'{}' climbs out with '..', which is not allowed", name));
  }
  for (const fs::path& folder : {including_folder, include_folder_}) {
    std::error_code code;
    const fs::path candidate = folder / relative;
    if (folder.empty() || !fs::exists(candidate, code)) {
      continue;
    }
    const std::string why = whyNotAFile(candidate);
    if (!why.empty()) {
      return inputError("", fmt::format("'{}' cannot be included: {}", name, why));
    }
    fs::path canonical = fs::canonical(candidate, code);
    if (code || !contains(canonical)) {
      return inputError("", fmt::format("'{}' is a symbolic link out of the shader folder", name));
    }
    return canonical;
  }
  return inputError("", missingMessage(name, including_folder));
}

}  // namespace ssrkit
