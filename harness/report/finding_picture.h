#pragma once

#include <string>

#include "base/error.h"
#include "check/check_result.h"

namespace ssrkit {

// The map as a PNG in base64, for pages that carry their pictures: dark ground, findings from orange to
// yellow.
[[nodiscard]] Expected<std::string> findingPictureBase64(const FindingMap& map);

}  // namespace ssrkit
