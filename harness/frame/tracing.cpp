#include "frame/tracing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "frame/image_transfer.h"
#include "frame/stages.h"
#include "frame/technique_in_frame.h"
#include "frame/trace_pass.h"

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

// Puts the rays of every stride-th texel where they started from. The other texels are told as not
// reflective, in the record and in the material that the tracer is held to.
Expected<void> spreadRays(Device& device, const FrameImages& images, int stride, TraceResult& result) {
  const auto dist_view = readImage(device, *images.find("dist_view"), {"Z"});
  auto material = readImage(device, *images.find("material"), frameImageRow("material").channels);
  if (!dist_view || !material) {
    return tl::make_unexpected(dist_view ? material.error() : dist_view.error());
  }
  constexpr std::size_t kReflective = 2;
  RayRecord all{images.size(), {}};
  for (int y = 0; y < all.size.height; ++y) {
    for (int x = 0; x < all.size.width; ++x) {
      if (x % stride == 0 && y % stride == 0) {
        all.rays.push_back(result.record.at(x / stride, y / stride));
      } else {
        const bool is_background = std::isinf(dist_view->at(x, y));
        all.rays.push_back({.ray_class = is_background ? RayClass::kBackground : RayClass::kMasked});
        material->at(x, y, kReflective) = 0.0F;
      }
    }
  }
  result.record = std::move(all);
  result.images.emplace("material", std::move(*material));
  return {};
}

// The passes of the trace itself, its tracer's own the last. A peer's inputs and answer go into the technique
// around it; its trace has no depth.
Expected<std::vector<PreparedPass>> prepareTrace(Programs& programs, const CompileSettings& settings,
                                                 const TraceRequest& request, const std::string& shader,
                                                 Technique& technique, const Progress& progress) {
  if (!request.peer) {
    drawWhereRaysStart(technique);
    return preparePasses(programs, settings, tracePasses(shader, technique), progress);
  }
  technique.before_trace.insert(technique.before_trace.begin(), peerInputs(*request.peer));
  technique.after_sample.insert(technique.after_sample.begin(), peerAnswer(*request.peer));
  auto trace = preparePasses(programs, settings, {peerTrace(*request.peer)}, progress);
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

void Tracing::watchHistory(History& history, const std::string& owner) {
  for (std::vector<PreparedPass>* passes : {&before_trace_, &after_sample_, &after_trace_}) {
    history.watchTrace(*passes, owner);
  }
}

Expected<void> Tracing::drawAll(Device& device, const std::vector<PreparedPass>& passes, FrameImages& images,
                                const UniformValues& values, const Progress& progress) {
  for (const PreparedPass& pass : passes) {
    progress("draw " + pass.pass.name);
    const auto time = drawPass(device, pass, images, values);
    if (!time) {
      return tl::make_unexpected(time.error());
    }
    times_.add(pass.pass.name, *time);
  }
  return {};
}

std::string Tracing::depthImage() const {
  const auto own = technique_.trace_inputs.find("dist_view");
  return own != technique_.trace_inputs.end() ? own->second : "dist_view";
}

Expected<void> Tracing::drawTrace(Device& device, FrameImages& images, const UniformValues& values,
                                  const Progress& progress) {
  for (const PreparedPass& pass : trace_) {
    progress("draw " + pass.pass.name);
    const auto time = drawPass(device, pass, images, values);
    if (!time) {
      return tl::make_unexpected(time.error());
    }
    times_.add("trace", *time);
  }
  return {};
}

Expected<void> Tracing::draw(Device& device, FrameImages& images, UniformValues& values,
                             const Progress& progress) {
  setTraceUniforms(values, parameters_);
  const int stride = technique_.ray_stride_texels;
  values.set("ray_stride_texels", stride);
  values.set("rays_uv", 1.0 / glm::dvec2((images.size().width + stride - 1) / stride,
                                         (images.size().height + stride - 1) / stride));
  if (const auto done = drawAll(device, before_pyramid_, images, values, progress); !done) {
    return done;
  }
  if (layout_ != PyramidLayout::kNone) {
    progress("draw pyramid for " + stage_);
    const auto time =
        buildPyramid(device, pyramid_, layout_, parameters_.max_mip, depthImage(), images, values);
    if (!time) {
      return tl::make_unexpected(time.error());
    }
    times_.add("pyramid", *time);
  }
  values.set("sample_count", technique_.sample_count);
  for (int sample = 0; sample < technique_.sample_count; ++sample) {
    values.set("sample_index", sample);
    auto done = drawAll(device, before_trace_, images, values, progress);
    done = done ? drawTrace(device, images, values, progress) : done;
    done = done ? drawAll(device, after_sample_, images, values, progress) : done;
    if (!done) {
      return done;
    }
  }
  const auto done = drawAll(device, after_trace_, images, values, progress);
  times_.endRound();
  return done;
}

std::map<std::string, std::string> Tracing::pictures() const {
  // What the tracer read in the place of the frame's own is told under the frame's name for it.
  std::map<std::string, std::string> pictures = technique_.trace_inputs;
  for (const std::string& name : technique_.read_back) {
    pictures.emplace(name, name);
  }
  return pictures;
}

std::set<std::string> Tracing::imagesToRead() const {
  const std::string suffix = recordSuffix(technique_);
  std::set<std::string> names = {"hit_texel" + suffix, "hit_point" + suffix, "ray_work" + suffix};
  for (const auto& [name, source] : pictures()) {
    names.insert(source);
  }
  return names;
}

Expected<TraceResult> Tracing::read(Device& device, const FrameImages& images) const {
  TraceResult result{.stage = stage_,
                     .technique = technique_.name,
                     .parameters = parameters_,
                     .record = {},
                     .images = {},
                     .passes = times_.reports()};
  const std::string suffix = recordSuffix(technique_);
  auto record = readRecord(device, *images.find("hit_texel" + suffix), *images.find("hit_point" + suffix),
                           *images.find("ray_work" + suffix));
  if (!record) {
    return tl::make_unexpected(record.error());
  }
  result.record = std::move(*record);
  for (const auto& [name, source] : pictures()) {
    auto image = readImage(device, *images.find(source), frameImageRow(source).channels);
    if (!image) {
      return tl::make_unexpected(image.error());
    }
    result.images.emplace(name, std::move(*image));
  }
  if (technique_.ray_stride_texels > 1) {
    if (const auto spread = spreadRays(device, images, technique_.ray_stride_texels, result); !spread) {
      return tl::make_unexpected(spread.error());
    }
  }
  return result;
}

}  // namespace ssrkit
