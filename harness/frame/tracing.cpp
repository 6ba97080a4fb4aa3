#include "frame/tracing.h"

#include <fmt/format.h>

#include <algorithm>

#include "frame/image_transfer.h"

namespace ssrkit {

namespace {

FrameStep fullScreenStep(const std::string& name, std::vector<std::string> outputs) {
  FrameStep step{.row = {.name = name,
                         .vertex_shader = "full_screen.vert",
                         .fragment_shader = name + ".frag",
                         .colour_formats = {},
                         .has_depth = false,
                         .vertex_attributes = {},
                         .vertex_stride_bytes = 0},
                 .outputs = std::move(outputs)};
  for (const std::string& output : step.outputs) {
    step.row.colour_formats.push_back(frameImageRow(output).format);
  }
  return step;
}

const FrameStep& resolveStep() {
  static const FrameStep step = fullScreenStep("resolve", {"reflection"});
  return step;
}

const FrameStep& compositeStep() {
  static const FrameStep step = fullScreenStep("composite", {"composite"});
  return step;
}

void setTraceUniforms(UniformValues& values, const TraceParameters& parameters) {
  values.set("thickness_m", parameters.thickness_m);
  values.set("thickness_rel", parameters.thickness_rel);
  values.set("max_distance_m", parameters.max_distance_m);
  values.set("origin_bias", parameters.origin_bias);
  values.set("step_m", parameters.step_m);
  values.set("stride_px", static_cast<double>(parameters.stride_px));
  values.set("jitter", parameters.jitter);
  values.set("lookup_budget", parameters.lookup_budget);
  values.set("step_count", parameters.step_count);
  values.set("bisection_count", parameters.bisection_count);
  values.set("max_mip", parameters.max_mip);
}

}  // namespace

const FrameStep& lightStep() {
  static const FrameStep step = fullScreenStep("light", {"lit"});
  return step;
}

FrameStep traceStep(const std::string& shader) {
  return fullScreenStep(shader.substr(0, shader.find('.')), {"hit_texel", "hit_point", "ray_work"});
}

Expected<PassTime> drawStep(Device& device, const Program& program, const FrameStep& step,
                            FrameImages& images, const UniformValues& values) {
  FullScreenPass pass{.row = &step.row,
                      .targets = {},
                      .viewport = {0, 0, images.size().width, images.size().height},
                      .aliases = {}};
  for (const std::string& output : step.outputs) {
    const auto image = images.get(output);
    if (!image) {
      return tl::make_unexpected(image.error());
    }
    pass.targets.push_back({*image, 0, std::nullopt});
  }
  return drawFullScreen(device, program, pass, images, values);
}

Expected<Tracing> Tracing::prepare(Programs& programs, const CompileSettings& settings,
                                   const TraceRequest& request, Size size, const Progress& progress) {
  const auto stage = findStage(request.stage);
  if (!stage) {
    return tl::make_unexpected(stage.error());
  }
  Tracing tracing;
  tracing.stage_ = request.stage;
  tracing.parameters_ = withStageDefaults(request.parameters, **stage, size);
  tracing.want_color_ = request.want_color;
  tracing.trace_step_ = traceStep(shaderOf(**stage, tracing.parameters_));
  struct Need {
    const PassRow* row;
    const Program** program;
  };
  std::vector<Need> needs = {{&tracing.trace_step_.row, &tracing.trace_}};
  if (request.want_color) {
    needs.push_back({&resolveStep().row, &tracing.resolve_});
    needs.push_back({&compositeStep().row, &tracing.composite_});
  }
  for (std::size_t i = 0; i < needs.size(); ++i) {
    progress("compile " + needs[i].row->name);
    const auto program = programs.get(*needs[i].row, settings);
    if (!program) {
      return tl::make_unexpected(program.error());
    }
    *needs[i].program = *program;
    if (i == 0 && pyramidLayoutOf(**program) != PyramidLayout::kNone) {
      tracing.layout_ = pyramidLayoutOf(**program);
      needs.push_back({&pyramidBasePass(), &tracing.pyramid_.base});
      needs.push_back({&pyramidReducePass(), &tracing.pyramid_.reduce});
    }
  }
  return tracing;
}

void Tracing::addTime(const std::string& pass, const PassTime& time) {
  auto report = std::ranges::find(reports_, pass, &PassReport::pass);
  if (report == reports_.end()) {
    reports_.push_back({.pass = pass, .cold = time, .steady = {}});
  } else {
    report->steady.push_back(time);
  }
}

Expected<void> Tracing::draw(Device& device, FrameImages& images, UniformValues& values,
                             const Progress& progress) {
  setTraceUniforms(values, parameters_);
  if (layout_ != PyramidLayout::kNone) {
    progress("draw pyramid for " + stage_);
    const auto time = buildPyramid(device, pyramid_, layout_, parameters_.max_mip, images, values);
    if (!time) {
      return tl::make_unexpected(time.error());
    }
    addTime("pyramid", *time);
  }
  progress("draw " + trace_step_.row.name);
  const auto time = drawStep(device, *trace_, trace_step_, images, values);
  if (!time) {
    return tl::make_unexpected(time.error());
  }
  addTime("trace", *time);
  return want_color_ ? drawColour(device, images, values) : Expected<void>{};
}

Expected<void> Tracing::drawColour(Device& device, FrameImages& images, const UniformValues& values) {
  const auto resolved = drawStep(device, *resolve_, resolveStep(), images, values);
  if (!resolved) {
    return tl::make_unexpected(resolved.error());
  }
  addTime("resolve", *resolved);
  const auto composed = drawStep(device, *composite_, compositeStep(), images, values);
  if (!composed) {
    return tl::make_unexpected(composed.error());
  }
  addTime("composite", *composed);
  return {};
}

Expected<TraceResult> Tracing::read(Device& device, const FrameImages& images) const {
  TraceResult result{.stage = stage_,
                     .parameters = parameters_,
                     .record = {},
                     .reflection = std::nullopt,
                     .composite = std::nullopt,
                     .passes = reports_};
  auto record =
      readRecord(device, *images.find("hit_texel"), *images.find("hit_point"), *images.find("ray_work"));
  if (!record) {
    return tl::make_unexpected(record.error());
  }
  result.record = std::move(*record);
  if (want_color_) {
    for (auto [name, to] :
         {std::pair{"reflection", &result.reflection}, std::pair{"composite", &result.composite}}) {
      auto image = readImage(device, *images.find(name), frameImageRow(name).channels);
      if (!image) {
        return tl::make_unexpected(image.error());
      }
      *to = std::move(*image);
    }
  }
  return result;
}

}  // namespace ssrkit
