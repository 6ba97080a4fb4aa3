// Somebody's fragment shader in the place of a tracer: what it reads under which names, and what its answer
// means.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/error.h"
#include "frame/uniform_values.h"

namespace ssrkit {

struct FramePass;
struct Program;

// The depth that it reads, by its number in shaders/peer_inputs.frag.
enum class PeerDepth {
  kDistView,        // metres along the view direction, +inf for background
  kViewZ,           // the same, negative, -1e30 for background
  kWindow,          // 0 at the near plane, 1 at the far plane and for background
  kWindowReversed,  // 1 at the near plane, 0 at the far plane and for background
  kLinear01,        // metres over the far plane's, 1 for background
};

// What the mips of its depth hold of the texels below them.
enum class PeerMips {
  kNone,      // it has none
  kNearest,   // the nearest surface's depth: what a ray before it may pass
  kFarthest,  // the farthest's
};

// The normal that it reads; view space, +z towards the viewer unless said otherwise.
enum class PeerNormal {
  kSigned,
  kUnsigned,  // n * 0.5 + 0.5
  kForward,   // +z away from the viewer, as in left-handed view spaces
};

// What it writes to its output's first two channels, where it says that it hit.
enum class PeerAnswer {
  kUv,         // position / size, origin upper left
  kUvUpwards,  // the same, origin lower left
  kTexel,      // whole texels, origin upper left
  kMask,       // nothing: it tells hits from misses only
};

struct PeerShader {
  std::string name;
  std::filesystem::path file;  // GLSL, or HLSL where its name ends in .hlsl; its entry is main
  // Its samplers to "depth", "normal" (in the forms above) or an image of the frame by name.
  std::map<std::string, std::string> images;
  // Its block's members to the kit's values, or to numbers of their own.
  std::map<std::string, std::string> values;
  std::map<std::string, UniformConstant> constants;
  PeerDepth depth = PeerDepth::kDistView;
  PeerMips mips = PeerMips::kNone;
  PeerNormal normal = PeerNormal::kSigned;
  PeerAnswer answer = PeerAnswer::kUv;
  int hit_channel = 3;       // over 0: it hit
  int lookups_channel = -1;  // of its output; -1: it counts none

  bool operator==(const PeerShader&) const = default;
};

// Fails when the shader has no sampler or block member of a name that the peer's file gives.
[[nodiscard]] Expected<void> checkPeerNames(const PeerShader& peer, const Program& program);

// Before it: the depth and normal that it expects. It: one float output of four channels, drawn as the kit's
// tracers are, where rays start. After it: its answer as the kit's ray record; a miss is given the class of
// the ray's end, which a peer has no word for.
[[nodiscard]] std::vector<FramePass> peerInputs(const PeerShader& peer);
[[nodiscard]] std::vector<FramePass> peerTrace(const PeerShader& peer);
[[nodiscard]] FramePass peerAnswer(const PeerShader& peer);

}  // namespace ssrkit
