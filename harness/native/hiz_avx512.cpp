#include "native/hiz_march.h"

namespace ssrkit {

const HizKernel kHizAvx512{"AVX-512", kLaneCount, &traceTexels};

}  // namespace ssrkit
