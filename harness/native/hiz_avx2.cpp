#include "native/hiz_march.h"

namespace ssrkit {

const HizKernel kHizAvx2{"AVX2", kLaneCount, &traceTexels};

}  // namespace ssrkit
