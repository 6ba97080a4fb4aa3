#include "native/hiz_march.h"

namespace ssrkit {

const HizKernel kHizBaseline{"baseline", kLaneCount, &traceTexels};

}  // namespace ssrkit
