// What a trace is drawn by: its technique's passes, its tracer or its peer, its pyramid, all compiled.
#include <utility>

#include "frame/stages.h"
#include "frame/technique_in_frame.h"
#include "frame/trace_pass.h"
#include "frame/tracing.h"

namespace ssrkit {

namespace {

// No picture: the trace alone.
const Technique& noTechnique() {
  static const Technique none{.name = "", .about = "", .frame = "", .read_back = {}};
  return none;
}

// As the job's frame draws it.
Expected<Technique> techniqueOf(const Job& job, const TraceRequest& request) {
  if (request.technique.empty()) {
    return noTechnique();
  }
  const auto kind = findFrameKind(job.frame);
  const auto technique = findTechnique(request.technique);
  if (!kind || !technique) {
    return tl::make_unexpected(kind ? technique.error() : kind.error());
  }
  return inFrame(**technique, **kind);
}

// The passes of the trace itself, its tracer's own the last. A peer's inputs and answer go into the technique
// around it.
Expected<std::vector<PreparedPass>> prepareTrace(Programs& programs, const CompileSettings& settings,
                                                 const TraceRequest& request, const std::string& shader,
                                                 Technique& technique, const Progress& progress) {
  if (!request.peer) {
    drawWhereRaysStart(technique);
    return preparePasses(programs, settings, tracePasses(shader, technique), progress);
  }
  const std::vector<FramePass> inputs = peerInputs(*request.peer);
  technique.before_trace.insert(technique.before_trace.begin(), inputs.begin(), inputs.end());
  technique.after_sample.insert(technique.after_sample.begin(), peerAnswer(*request.peer));
  auto trace = preparePasses(programs, settings, peerTrace(*request.peer), progress);
  if (trace) {
    if (const auto checked = checkPeerNames(*request.peer, *trace->back().program); !checked) {
      return tl::make_unexpected(checked.error());
    }
  }
  return trace;
}

Expected<PyramidPrograms> pyramidPrograms(Programs& programs, const CompileSettings& settings,
                                          const Progress& progress) {
  PyramidPrograms pyramid;
  for (const auto& [row, program] :
       {std::pair{&pyramidBasePass(), &pyramid.base}, std::pair{&pyramidReducePass(), &pyramid.reduce}}) {
    progress("compile " + row->name);
    const auto compiled = programs.get(*row, settings);
    if (!compiled) {
      return tl::make_unexpected(compiled.error());
    }
    *program = *compiled;
  }
  return pyramid;
}

}  // namespace

Expected<Tracing> Tracing::prepare(Programs& programs, const CompileSettings& settings, const Job& job,
                                   const TraceRequest& request, const Progress& progress) {
  // A peer is no row; what the parameters leave open is the exact walk's.
  const auto stage = findStage(request.peer ? "walk" : request.stage);
  if (!stage) {
    return tl::make_unexpected(stage.error());
  }
  auto technique = techniqueOf(job, request);
  if (!technique) {
    return tl::make_unexpected(technique.error());
  }
  Tracing tracing;
  tracing.stage_ = request.stage;
  tracing.parameters_ = withStageDefaults(request.parameters, **stage, job.size);
  tracing.technique_ = std::move(*technique);
  auto trace = prepareTrace(programs, settings, request, shaderOf(**stage, tracing.parameters_),
                            tracing.technique_, progress);
  if (!trace) {
    return tl::make_unexpected(trace.error());
  }
  tracing.trace_ = std::move(*trace);
  tracing.layout_ = pyramidLayoutOf(*tracing.trace_.back().program);
  if (tracing.layout_ != PyramidLayout::kNone) {
    const auto pyramid = pyramidPrograms(programs, settings, progress);
    if (!pyramid) {
      return tl::make_unexpected(pyramid.error());
    }
    tracing.pyramid_ = *pyramid;
  }
  for (const auto& [passes, prepared] :
       {std::pair{&tracing.technique_.before_pyramid, &tracing.before_pyramid_},
        std::pair{&tracing.technique_.before_trace, &tracing.before_trace_},
        std::pair{&tracing.technique_.after_sample, &tracing.after_sample_},
        std::pair{&tracing.technique_.after_trace, &tracing.after_trace_}}) {
    auto compiled = preparePasses(programs, settings, *passes, progress);
    if (!compiled) {
      return tl::make_unexpected(compiled.error());
    }
    *prepared = std::move(*compiled);
  }
  return tracing;
}

}  // namespace ssrkit
