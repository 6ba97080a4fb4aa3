#include "frame/tracing.h"

#include <cmath>

#include "frame/image_transfer.h"
#include "frame/trace_pass.h"

namespace ssrkit {

namespace {

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

}  // namespace

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
    // What the tracer's sampler of either layout reads.
    trace_.back().pass.inputs[layout_ == PyramidLayout::kAtlas ? "pyramid_atlas" : "pyramid"] =
        pyramidImage(layout_, parameters_.max_mip, depthImage(), images);
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
