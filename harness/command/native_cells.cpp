#include "command/native_cells.h"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <utility>

#include "native/trace.h"

namespace ssrkit {

namespace {

constexpr int kThreads = 2;
constexpr const char* kStage = "hiz";
constexpr std::array kInputs = {"dist_view", "normal_view", "material"};

const NativePeer* findPeer(const std::string& name) {
  static const std::vector<NativePeer> peers = nativePeers();
  const auto found = std::ranges::find(peers, name, &NativePeer::name);
  return found == peers.end() ? nullptr : &*found;
}

std::vector<std::string> withOrWithoutPeers(std::span<const std::string> names, bool are_peers) {
  std::vector<std::string> kept;
  std::ranges::copy_if(names, std::back_inserter(kept), [are_peers](const std::string& name) {
    return (findPeer(name) != nullptr) == are_peers;
  });
  return kept;
}

// A technique may have given its tracer images of its own; those are the shaders' alone.
bool isTracedNatively(const TraceResult& trace) {
  return trace.stage == kStage &&
         std::ranges::none_of(kInputs, [&](const char* image) { return trace.images.contains(image); });
}

// Every trace of the cell once.
void traceRound(CellRun& cell, const std::function<void(TraceResult&, NativeTrace)>& take) {
  for (TraceResult& trace : cell.result->traces) {
    const OracleInput input{.camera = &cell.result->camera,
                            .dist_view = &cell.result->images.at("dist_view"),
                            .normal_view = &cell.result->images.at("normal_view"),
                            .mask = &cell.mask,
                            .parameters = trace.parameters};
    auto native = traceNative(input, kThreads, findPeer(cell.native_peer)->instruction_set);
    if (!native) {
      cell.error = std::move(native.error());
      return;
    }
    take(trace, std::move(*native));
  }
}

PassTime passTime(const NativeTime& time) {
  return {.wall_ns = time.wall_ns, .cpu_ns = time.cpu_ns, .device_ns = std::nullopt};
}

void timeRounds(CellRun& cell, int rounds) {
  for (int round = 0; round < rounds && !cell.error; ++round) {
    traceRound(cell, [](TraceResult& trace, const NativeTrace& native) {
      trace.passes[0].steady.push_back(passTime(native.pyramid));
      trace.passes[1].steady.push_back(passTime(native.trace));
    });
  }
}

// The input of the peers, and their traces without an answer.
JobResult unanswered(const JobResult& over) {
  JobResult result{.camera = over.camera};
  for (const char* image : kInputs) {
    if (const auto found = over.images.find(image); found != over.images.end()) {
      result.images.insert(*found);
    }
  }
  for (const TraceResult& trace : over.traces) {
    if (isTracedNatively(trace)) {
      result.traces.push_back(
          {.stage = trace.stage, .technique = trace.technique, .parameters = trace.parameters});
    }
  }
  return result;
}

}  // namespace

std::vector<std::string> nativePeersHere() {
  std::vector<std::string> names;
  for (const NativePeer& peer : nativePeers()) {
    if (peer.runs_here) {
      names.push_back(peer.name);
    }
  }
  return names;
}

std::vector<std::string> devicesAmong(std::span<const std::string> names) {
  return withOrWithoutPeers(names, false);
}

std::vector<std::string> nativePeersAmong(std::span<const std::string> names) {
  return withOrWithoutPeers(names, true);
}

void addNativeCells(std::span<const std::string> peers, const CellRun& over, int rounds, SceneRun& run) {
  if (!over.result || std::ranges::none_of(over.result->traces, isTracedNatively)) {
    return;
  }
  for (const std::string& peer : peers) {
    CellRun cell{.device = peer, .size = over.size, .native_peer = peer, .cases = over.cases};
    cell.mask = over.mask;
    cell.result = unanswered(*over.result);
    for (std::size_t i = 0; i < over.result->traces.size(); ++i) {
      if (isTracedNatively(over.result->traces[i])) {
        cell.case_of_trace.push_back(over.case_of_trace[i]);
      }
    }
    traceRound(cell, [](TraceResult& trace, NativeTrace native) {
      trace.record = std::move(native.record);
      trace.passes = {{.pass = "pyramid", .cold = passTime(native.pyramid), .steady = {}},
                      {.pass = "trace", .cold = passTime(native.trace), .steady = {}}};
    });
    timeRounds(cell, rounds);
    run.cells.push_back(std::move(cell));
  }
}

void timeNativeAgain(CellRun& cell, int rounds) {
  traceRound(cell,
             [](TraceResult&, const NativeTrace&) {});  // what another process left in the caches is gone
  timeRounds(cell, rounds);
}

}  // namespace ssrkit
