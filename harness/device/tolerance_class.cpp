#include "device/tolerance_class.h"

#include "base/check.h"

namespace ssrkit {

ToleranceClass toleranceClass(const DeviceEntry& a, const DeviceEntry& b) {
  if (a.pipeline == b.pipeline) {
    return ToleranceClass::kSamePipeline;
  }
  return a.rasteriser == b.rasteriser ? ToleranceClass::kSameRasteriser : ToleranceClass::kOther;
}

std::string_view letterOf(ToleranceClass tolerance) {
  switch (tolerance) {
    case ToleranceClass::kSamePipeline:
      return "P";
    case ToleranceClass::kSameRasteriser:
      return "R";
    case ToleranceClass::kOther:
      return "X";
  }
  SSRKIT_CHECK(false);
}

}  // namespace ssrkit
