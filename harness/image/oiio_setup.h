#pragma once

namespace ssrkit {

inline constexpr int kMaxImageSide = 16384;  // texels
inline constexpr int kMaxImageChannels = 1024;
inline constexpr long long kMaxImageBytes = 2LL << 30;  // decoded

// Sets OpenImageIO's limits and keeps it to the calling thread: workers and oracles share the cores, and
// callers that write many files write them side by side. Cheap to call again; every use of the library does.
void setUpOiio();

}  // namespace ssrkit
