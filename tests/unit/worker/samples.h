// A job and a result in which no field has its default value and every kind of number occurs.
#pragma once

#include "frame/job.h"
#include "worker/supervisor.h"

namespace ssrkit {

[[nodiscard]] Job sampleJob();
[[nodiscard]] JobResult sampleResult();

// Equal bit by bit: NaNs too, and -0 is not 0.
[[nodiscard]] bool sameBits(const Image& a, const Image& b);
[[nodiscard]] bool sameBits(const Camera& a, const Camera& b);
[[nodiscard]] bool sameBits(const TraceParameters& a, const TraceParameters& b);
[[nodiscard]] bool sameBits(const RayRecord& a, const RayRecord& b);
[[nodiscard]] bool sameBits(const std::vector<PassReport>& a, const std::vector<PassReport>& b);
[[nodiscard]] bool sameBits(const Job& a, const Job& b);
[[nodiscard]] bool sameBits(const JobResult& a, const JobResult& b);

}  // namespace ssrkit
