#pragma once

#include <string>
#include <string_view>

namespace ssrkit::vulkan {

// The loader's manifest of an installed driver ("lvp_icd" finds /usr/share/vulkan/icd.d/lvp_icd.x86_64.json),
// or "" where there is none. Reads names of files only and loads nothing.
[[nodiscard]] std::string findDriverFile(std::string_view name_part);

}  // namespace ssrkit::vulkan
