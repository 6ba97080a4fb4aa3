#include "frame/peer.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/text.h"
#include "frame/frame_pass.h"
#include "frame/trace_pass.h"

namespace ssrkit {

namespace {

template <class Names>
Expected<void> checkNames(const PeerShader& peer, const Names& given, const std::vector<std::string>& known,
                          const std::string& what) {
  for (const auto& [name, target] : given) {
    if (std::ranges::find(known, name) == known.end()) {
      const auto nearest = nearestName(name, known);
      return inputError(fmt::format("use the peer '{}'", peer.name),
                        fmt::format("its shader has no {} called '{}'", what, name), peer.file.string(),
                        nearest ? fmt::format("did you mean '{}'?", *nearest)
                        : known.empty()
                            ? fmt::format("it has no {} at all; what it does not use is left out", what)
                            : fmt::format("it has {}", joinNames(known)));
    }
  }
  return {};
}

std::string depthOf(const PeerShader& peer) {
  return peer.mips == PeerMips::kNone ? "peer_depth" : "peer_depth_mips";
}

// Whether its mips hold the greatest number below them, and not the least.
bool keepsGreatest(const PeerShader& peer) {
  const bool nearer_is_greater = peer.depth == PeerDepth::kViewZ || peer.depth == PeerDepth::kWindowReversed;
  return nearer_is_greater == (peer.mips == PeerMips::kNearest);
}

}  // namespace

Expected<void> checkPeerNames(const PeerShader& peer, const Program& program) {
  std::vector<std::string> samplers;
  std::ranges::transform(program.samplers, std::back_inserter(samplers), &SamplerBinding::name);
  std::vector<std::string> members;
  if (program.uniform_block) {
    std::ranges::transform(program.uniform_block->members, std::back_inserter(members), &BlockMember::name);
  }
  auto checked = checkNames(peer, peer.images, samplers, "sampler");
  checked = checked ? checkNames(peer, peer.values, members, "block member") : checked;
  return checked ? checkNames(peer, peer.constants, members, "block member") : checked;
}

std::vector<FramePass> peerInputs(const PeerShader& peer) {
  std::vector<FramePass> passes = {{.name = "peer_inputs",
                                    .outputs = {depthOf(peer), "peer_normal"},
                                    .constants = {{"peer_depth_form", static_cast<int>(peer.depth)},
                                                  {"peer_normal_form", static_cast<int>(peer.normal)}}}};
  if (peer.mips != PeerMips::kNone) {
    passes.push_back({.name = "peer_mips",
                      .outputs = {depthOf(peer)},
                      .constants = {{"peer_mips_sign", keepsGreatest(peer) ? -1.0 : 1.0}},
                      .fills_mips = true});
  }
  return passes;
}

std::vector<FramePass> peerTrace(const PeerShader& peer) {
  const FramePass& without_ray = withoutRayPass();
  FramePass pass{.name = "peer " + peer.name,
                 .outputs = {"peer_answer"},
                 .constants = peer.constants,
                 .shader = peer.file.string(),
                 .depth = without_ray.depth,
                 .layer = without_ray.layer,
                 .clears = {"peer_answer"},
                 .values = peer.values};
  for (const auto& [sampler, image] : peer.images) {
    pass.inputs.emplace(sampler, image == "depth"    ? depthOf(peer)
                                 : image == "normal" ? "peer_normal"
                                                     : image);
  }
  return {without_ray, pass};
}

FramePass peerAnswer(const PeerShader& peer) {
  return {.name = "peer_record",
          .outputs = {"hit_texel", "hit_point", "ray_work"},
          .constants = {{"peer_answer_form", static_cast<int>(peer.answer)},
                        {"peer_hit_channel", peer.hit_channel},
                        {"peer_lookups_channel", peer.lookups_channel}}};
}

}  // namespace ssrkit
