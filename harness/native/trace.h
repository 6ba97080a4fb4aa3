// The Hi-Z tracer without a graphics API: what the CPU's own vectors make of the same G-buffer. Its record
// has the bits of the shaders'; its time is what they are measured against (docs/performance.md).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/error.h"
#include "image/ray_record.h"
#include "oracle/oracle.h"

namespace ssrkit {

struct NativeTime {
  std::int64_t cpu_ns = 0;  // of the process, all threads
  std::int64_t wall_ns = 0;
};

struct NativeTrace {
  RayRecord record;
  std::string instruction_set;  // "AVX-512"
  int lane_count = 0;           // rays marched at once, on each thread
  NativeTime pyramid;
  NativeTime trace;
};

// One set of instructions that the tracer is compiled for.
struct NativePeer {
  std::string name;             // where devices are named: "native-avx512"
  std::string instruction_set;  // for traceNative: "AVX-512"
  bool runs_here = false;       // this CPU has the instructions, and the kit was built for it
};

// The same list on every machine, widest first.
[[nodiscard]] std::vector<NativePeer> nativePeers();

// What this CPU runs, widest first: names for traceNative.
[[nodiscard]] std::vector<std::string> nativeInstructionSets();

// Traces the oracle's input by the stage `hiz`. The parameters must be a trace's as used: lookup_budget and
// max_mip filled in. `instruction_set`: one of nativeInstructionSets(), "" the widest. Fails where checkInput
// does.
[[nodiscard]] Expected<NativeTrace> traceNative(const OracleInput& input, int thread_count = 2,
                                                const std::string& instruction_set = "");

}  // namespace ssrkit
