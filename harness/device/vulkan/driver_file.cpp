#include "device/vulkan/driver_file.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>
#include <utility>

namespace ssrkit::vulkan {

namespace {

// The loader's own folders, and the one where Debian's chromium-common keeps SwiftShader.
constexpr std::array kFolders{"/etc/vulkan/icd.d", "/usr/local/share/vulkan/icd.d", "/usr/share/vulkan/icd.d",
                              "/usr/lib/chromium"};

// As Mesa writes it into the names of its manifests.
#if defined(__x86_64__)
constexpr std::string_view kProcessor = ".x86_64.";
#elif defined(__aarch64__)
constexpr std::string_view kProcessor = ".aarch64.";
#else
constexpr std::string_view kProcessor = ".";
#endif

}  // namespace

std::string driverFileAmong(std::vector<std::string> names) {
  std::ranges::sort(names);
  const auto own = std::ranges::find_if(
      names, [](const std::string& name) { return name.find(kProcessor) != std::string::npos; });
  return own != names.end() ? *own : names.empty() ? "" : names.front();
}

std::string findDriverFile(std::string_view name_part) {
  for (const char* const folder : kFolders) {
    std::vector<std::string> names;
    std::error_code unreadable;  // a folder that is not there has no drivers
    for (const auto& entry : std::filesystem::directory_iterator(folder, unreadable)) {
      const std::string name = entry.path().filename().string();
      if (name.find(name_part) != std::string::npos && name.ends_with(".json")) {
        names.push_back(name);
      }
    }
    if (!names.empty()) {
      return (std::filesystem::path(folder) / driverFileAmong(std::move(names))).string();
    }
  }
  return {};
}

}  // namespace ssrkit::vulkan
