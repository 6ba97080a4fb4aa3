#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ssrkit::vulkan {

// The loader's manifest of an installed driver ("lvp_icd" finds /usr/share/vulkan/icd.d/lvp_icd.x86_64.json),
// or "" where there is none. Reads names of files only and loads nothing.
[[nodiscard]] std::string findDriverFile(std::string_view name_part);

// Which of the manifests of one driver is for this program's processor: Debian keeps those of several
// architectures side by side (lvp_icd.i686.json beside lvp_icd.x86_64.json). The first by name where none
// says so; "" among none.
[[nodiscard]] std::string driverFileAmong(std::vector<std::string> names);

}  // namespace ssrkit::vulkan
