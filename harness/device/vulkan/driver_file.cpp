#include "device/vulkan/driver_file.h"

#include <array>
#include <filesystem>
#include <system_error>

namespace ssrkit::vulkan {

namespace {

// The loader's own folders, and the one where Debian's chromium-common keeps SwiftShader.
constexpr std::array kFolders{"/etc/vulkan/icd.d", "/usr/local/share/vulkan/icd.d", "/usr/share/vulkan/icd.d",
                              "/usr/lib/chromium"};

}  // namespace

std::string findDriverFile(std::string_view name_part) {
  for (const char* const folder : kFolders) {
    std::error_code unreadable;  // a folder that is not there has no drivers
    for (const auto& entry : std::filesystem::directory_iterator(folder, unreadable)) {
      const std::string name = entry.path().filename().string();
      if (name.find(name_part) != std::string::npos && name.ends_with(".json")) {
        return entry.path().string();
      }
    }
  }
  return {};
}

}  // namespace ssrkit::vulkan
